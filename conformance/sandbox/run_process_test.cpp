#include "conformance/sandbox/run_process.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/prctl.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "conformance/sandbox/file_descriptor.h"
#include "conformance/sandbox/run_fixture.h"

namespace plumb {
namespace {

using testing::HasSubstr;

class RunProcessTest : public RunTest {
 protected:
  /// Waits until a subject has made a file, which says that it runs. False if it takes a minute.
  bool wait_for(const std::string& name) const {
    for (int i = 0; i < 12'000; ++i) {
      if (std::filesystem::exists(folder_ / name)) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
  }
};

TEST_F(RunProcessTest, TellsTheExitCodeAndBothOutputs) {
  const RunOutcome outcome = run_process(shell("echo out; echo err >&2; exit 3"));
  EXPECT_EQ(outcome.reason, StopReason::exited);
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(outcome.signal, 0);
  EXPECT_EQ(outcome.log, "out\nerr\n");
  EXPECT_EQ(outcome.log_bytes_dropped, 0);
  EXPECT_GT(outcome.wall_seconds, 0);
  EXPECT_GE(outcome.cpu_seconds, 0);
  EXPECT_EQ(outcome.active_limits.size(), 6u);
  EXPECT_EQ(outcome.start_error, "");
}

TEST_F(RunProcessTest, TellsTheSignal) {
  const RunOutcome outcome = run_process(shell("kill -SEGV $$"));
  EXPECT_EQ(outcome.reason, StopReason::signalled);
  EXPECT_EQ(outcome.signal, SIGSEGV);
  EXPECT_EQ(outcome.exit_code, -1);
}

TEST_F(RunProcessTest, HandsOverOnlyTheGivenEnvironment) {
  ASSERT_EQ(::setenv("PLUMB_SECRET", "1", 1), 0);
  ProcessRequest env = request({"env"});
  env.environment.push_back("ODD=a=b c\nd");
  const RunOutcome outcome = run_process(env);
  EXPECT_EQ(outcome.log, "PATH=/usr/bin:/bin\n" + mark() + "\nODD=a=b c\nd\n");
}

TEST_F(RunProcessTest, HandsOverNothingElse) {
  // Open here, one of them even across an exec, and a handler and a blocked signal that must not be inherited.
  const FileDescriptor secret(::open("/dev/zero", O_RDONLY));
  ASSERT_TRUE(secret.valid());
  struct sigaction before;
  struct sigaction ignore = {};
  ignore.sa_handler = SIG_IGN;
  ASSERT_EQ(::sigaction(SIGUSR1, &ignore, &before), 0);
  sigset_t blocked;
  sigset_t mask;
  ::sigemptyset(&blocked);
  ::sigaddset(&blocked, SIGUSR2);
  ASSERT_EQ(::pthread_sigmask(SIG_BLOCK, &blocked, &mask), 0);
  const RunOutcome outcome = run_process(subject({"print-state"}));
  ::pthread_sigmask(SIG_SETMASK, &mask, nullptr);
  ::sigaction(SIGUSR1, &before, nullptr);
  EXPECT_EQ(outcome.log, "open 0\nopen 1\nopen 2\nsession 1\ngroup 1\numask 022\ncore 0\nprivileges 0\n");
}

TEST_F(RunProcessTest, GivesAnEmptyStandardInput) {
  const RunOutcome outcome = run_process(shell("cat; echo end"));
  EXPECT_EQ(outcome.log, "end\n");
}

TEST_F(RunProcessTest, StartsInTheFolder) {
  std::filesystem::create_directory(folder_ / "a");
  ProcessRequest pwd = shell("pwd");
  pwd.folder = folder_ / "a";
  EXPECT_EQ(run_process(pwd).log, (folder_ / "a").string() + "\n");
}

TEST_F(RunProcessTest, SaysWhyAProgramCannotStart) {
  const RunOutcome missing = run_process(request({"./tracer"}));
  EXPECT_EQ(missing.reason, StopReason::cannot_start);
  EXPECT_EQ(missing.start_error, "cannot run ./tracer: No such file or directory");
  EXPECT_EQ(missing.exit_code, -1);

  write("plain", "x");
  EXPECT_EQ(run_process(request({"./plain"})).start_error, "cannot run ./plain: Permission denied");
  EXPECT_EQ(run_process(request({"no-such-program"})).start_error,
            "cannot run no-such-program: No such file or directory");
  ProcessRequest nowhere = shell("true");
  nowhere.folder = folder_ / "gone";
  EXPECT_EQ(run_process(nowhere).start_error,
            "cannot enter " + nowhere.folder.string() + ": No such file or directory");
}

TEST_F(RunProcessTest, KeepsBothEndsOfALongLog) {
  ProcessRequest talk = shell("echo first; i=0; while [ $i -lt 500 ]; do echo line $i; i=$((i+1)); done; echo last");
  talk.limits.log_bytes = 100;
  const RunOutcome outcome = run_process(talk);
  EXPECT_EQ(outcome.reason, StopReason::exited);
  EXPECT_TRUE(outcome.log.starts_with("first\nline 0\n"));
  EXPECT_TRUE(outcome.log.ends_with("line 499\nlast\n"));
  EXPECT_THAT(outcome.log, HasSubstr("bytes dropped]\n"));
  EXPECT_GT(outcome.log_bytes_dropped, 3000);
}

TEST_F(RunProcessTest, NeverBlocksATalkativeProgram) {
  const RunOutcome outcome = run_process(subject({"print", "300000000"}));
  EXPECT_EQ(outcome.reason, StopReason::exited);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.log_bytes_dropped, 300'000'000 - (1 << 20));
}

TEST_F(RunProcessTest, EndsAProgramThatTalksForEver) {
  ProcessRequest talk = subject({"print", "0"});
  talk.limits.wall_seconds = 0.3;
  EXPECT_EQ(run_process(talk).reason, StopReason::wall_limit);
}

TEST_F(RunProcessTest, EndsWhatADaemonLeavesBehind) {
  const RunOutcome outcome = run_process(subject({"daemon"}));
  EXPECT_EQ(outcome.reason, StopReason::exited);
  EXPECT_EQ(outcome.exit_code, 0);
}

TEST_F(RunProcessTest, EndsABackgroundJobThatHoldsTheLog) {
  const RunOutcome outcome = run_process(shell("echo started; sleep 100 & exit 0"));
  EXPECT_EQ(outcome.reason, StopReason::exited);
  EXPECT_EQ(outcome.log, "started\n");
}

TEST_F(RunProcessTest, IsInterruptedByTheFlag) {
  std::thread setter([this] {
    EXPECT_TRUE(wait_for("ready"));
    interrupt_flag() = true;
  });
  const RunOutcome outcome = run_process(shell("touch ready; sleep 100 & sleep 100"));
  setter.join();
  EXPECT_EQ(outcome.reason, StopReason::interrupted);
  EXPECT_EQ(outcome.signal, SIGKILL);
  EXPECT_EQ(run_process(shell("touch again")).reason, StopReason::interrupted);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "again"));
}

TEST_F(RunProcessTest, RefusesASecondRunMeanwhile) {
  RunOutcome first;
  std::thread runner([&] { first = run_process(shell("touch ready; sleep 100")); });
  EXPECT_TRUE(wait_for("ready"));
  EXPECT_THROW(run_process(shell("true")), std::logic_error);
  interrupt_flag() = true;
  runner.join();
  EXPECT_EQ(first.reason, StopReason::interrupted);
  interrupt_flag() = false;
  EXPECT_EQ(run_process(shell("true")).reason, StopReason::exited);
}

TEST_F(RunProcessTest, RefusesRequestsThatMakeNoSense) {
  EXPECT_THROW(run_process(request({})), std::invalid_argument);
  EXPECT_THROW(run_process(request({""})), std::invalid_argument);
  EXPECT_THROW(run_process(request({"true", std::string("a\0b", 3)})), std::invalid_argument);
  ProcessRequest no_time = shell("true");
  no_time.limits.cpu_seconds = 0;
  EXPECT_THROW(run_process(no_time), std::invalid_argument);
  ProcessRequest nan_time = shell("true");
  nan_time.limits.wall_seconds = std::nan("");
  EXPECT_THROW(run_process(nan_time), std::invalid_argument);
  ProcessRequest no_folder = shell("true");
  no_folder.writable_folder = folder_ / "gone";
  EXPECT_THROW(run_process(no_folder), std::system_error);
  EXPECT_EQ(run_process(shell("true")).reason, StopReason::exited) << "a refusal must not count as a run";
}

TEST_F(RunProcessTest, LeavesOlderChildrenAlone) {
  const pid_t older = start_waiting_child();
  EXPECT_EQ(run_process(subject({"daemon"})).reason, StopReason::exited);
  EXPECT_EQ(::waitpid(older, nullptr, WNOHANG), 0) << "it must be running and not be waited for";
  end_child(older);
}

TEST_F(RunProcessTest, PutsTheCallerBackAsItWas) {
  struct sigaction ignore = {};
  ignore.sa_handler = SIG_IGN;
  struct sigaction before;
  ASSERT_EQ(::sigaction(SIGCHLD, &ignore, &before), 0);
  const RunOutcome outcome = run_process(shell("exit 5"));
  struct sigaction after;
  ASSERT_EQ(::sigaction(SIGCHLD, &before, &after), 0);
  EXPECT_EQ(outcome.exit_code, 5) << "although the caller ignores its children";
  EXPECT_EQ(after.sa_handler, SIG_IGN);
  int subreaper = -1;
  ASSERT_EQ(::prctl(PR_GET_CHILD_SUBREAPER, &subreaper), 0);
  EXPECT_EQ(subreaper, 0);
}

}  // namespace
}  // namespace plumb

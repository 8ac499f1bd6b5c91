#include "conformance/sandbox/process_tree.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

namespace plumb {
namespace {

TEST(ParseProcessStat, ReadsTheFieldsThatAreUsed) {
  const auto stat = parse_process_stat(
      "42 (cat) S 7 42 42 0 -1 4194304 90 0 0 0 11 12 13 14 20 0 5 0 987654 1000000 200 18446744073709551615 1 1");
  ASSERT_TRUE(stat);
  EXPECT_EQ(stat->id, (ProcessId{42, 987654}));
  EXPECT_EQ(stat->parent, 7);
  EXPECT_EQ(stat->state, 'S');
  EXPECT_EQ(stat->user, 11);
  EXPECT_EQ(stat->system, 12);
  EXPECT_EQ(stat->children_user, 13);
  EXPECT_EQ(stat->children_system, 14);
  EXPECT_EQ(stat->threads, 5);
}

TEST(ParseProcessStat, IsNotFooledByTheName) {
  const auto stat =
      parse_process_stat("42 (a) S 1 (\n) R 7 42 42 0 -1 4194304 90 0 0 0 11 12 13 14 20 0 5 0 987654 1000000 200");
  ASSERT_TRUE(stat);
  EXPECT_EQ(stat->state, 'R');
  EXPECT_EQ(stat->parent, 7);
}

TEST(ParseProcessStat, RefusesWhatIsNone) {
  for (const char* text :
       {"", "42", "42 (cat", "x (cat) S 1", "42 (cat)", "42 (cat) S", "42 (cat) S 7 42 42 0 -1", ")("}) {
    EXPECT_FALSE(parse_process_stat(text)) << text;
  }
}

TEST(ReadProcessStat, KnowsThisProcess) {
  const auto stat = read_process_stat(::getpid());
  ASSERT_TRUE(stat);
  EXPECT_EQ(stat->id.pid, ::getpid());
  EXPECT_EQ(stat->parent, ::getppid());
  EXPECT_GE(stat->threads, 1);
  EXPECT_FALSE(read_process_stat(-1));
}

class ProcessTreeTest : public testing::Test {
 protected:
  /// A child that waits for its end, below it another one if `deep`; both die with this process.
  static pid_t start(bool deep = false) {
    const pid_t child = ::fork();
    if (child != 0) return child;
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (deep && ::fork() == 0) ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (;;) ::pause();
  }
  static void end(pid_t child) {
    ::kill(child, SIGKILL);
    EXPECT_EQ(::waitpid(child, nullptr, 0), child);
  }
  /// Looks until `count` processes are there: a child's fork takes its time.
  static std::vector<ProcessStat> scan_until(ProcessTree& tree, std::size_t count) {
    std::vector<ProcessStat> found;
    for (int i = 0; i < 10'000 && found.size() != count; ++i) found = tree.scan();
    return found;
  }
};

TEST_F(ProcessTreeTest, FindsDescendantsParentsFirst) {
  ProcessTree tree;
  EXPECT_TRUE(tree.scan().empty());
  const pid_t child = start(true);
  const std::vector<ProcessStat> found = scan_until(tree, 2);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].id.pid, child);
  EXPECT_EQ(found[1].parent, child);
  end(child);
  // Not adopted here, the grandchild ends by itself, yet it stays known while it is there.
  EXPECT_TRUE(scan_until(tree, 0).empty());
}

TEST_F(ProcessTreeTest, SkipsOlderProcessesAndTheirNewChildren) {
  const pid_t older = start();
  ProcessTree tree;
  const pid_t newer = start();
  const std::vector<ProcessStat> found = tree.scan();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].id.pid, newer);
  end(newer);
  end(older);
}

TEST_F(ProcessTreeTest, SkipsWhatAnOlderProcessStartsLater) {
  const pid_t older = ::fork();
  if (older == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    sigset_t go;
    int signal = 0;
    ::sigemptyset(&go);
    ::sigaddset(&go, SIGUSR1);
    ::sigprocmask(SIG_BLOCK, &go, nullptr);
    ::raise(SIGSTOP);
    ::sigwait(&go, &signal);
    start();
    for (;;) ::pause();
  }
  ASSERT_EQ(::waitpid(older, nullptr, WUNTRACED), older);
  ProcessTree tree;
  ::kill(older, SIGCONT);
  ::kill(older, SIGUSR1);
  // Looked for in another way, the new one is found.
  bool started = false;
  for (int i = 0; i < 10'000 && !started; ++i) {
    EXPECT_TRUE(tree.scan().empty());
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
      const auto stat = read_process_stat(static_cast<pid_t>(std::atol(entry.path().filename().c_str())));
      started = started || (stat && stat->parent == older);
    }
  }
  EXPECT_TRUE(started);
  EXPECT_TRUE(tree.scan().empty());
  end(older);
}

TEST_F(ProcessTreeTest, SendsASignalToAllThatItFinds) {
  ProcessTree tree;
  const pid_t first = start();
  const pid_t second = start();
  EXPECT_EQ(tree.scan(SIGKILL).size(), 2u);
  int status = 0;
  EXPECT_EQ(::waitpid(first, &status, 0), first);
  EXPECT_EQ(::waitpid(second, &status, 0), second);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_TRUE(tree.scan().empty());
}

TEST_F(ProcessTreeTest, SendsNoSignalToAnotherProcessOfThatNumber) {
  const pid_t child = start();
  const auto stat = read_process_stat(child);
  ASSERT_TRUE(stat);
  EXPECT_FALSE(send_signal({child, stat->id.start + 1}, SIGKILL));
  EXPECT_EQ(::waitpid(child, nullptr, WNOHANG), 0) << "it must be alive";
  EXPECT_TRUE(send_signal(stat->id, SIGKILL));
  EXPECT_EQ(::waitpid(child, nullptr, 0), child);
  EXPECT_FALSE(send_signal(stat->id, SIGKILL));
}

}  // namespace
}  // namespace plumb

#include "conformance/sandbox/start_process.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <string>

#include "conformance/sandbox/log_capture.h"
#include "conformance/sandbox/run_fixture.h"

namespace plumb {
namespace {

class StartProcessTest : public RunTest {
 protected:
  /// An executable file of the folder with that text.
  void write_program(const std::string& name, const std::string& text, mode_t mode = 0755) const {
    ASSERT_EQ(::chmod(write(name, text).c_str(), mode), 0);
  }
  /// What a program printed that ends by itself; the reason if it did not start.
  std::string output_of(const ProcessRequest& request) const {
    const StartedProcess started = start_process(request);
    if (started.pid < 0) return started.error;
    EXPECT_EQ(::waitpid(started.pid, nullptr, 0), started.pid);
    LogCapture log(10'000);
    drain(started.log.get(), 1 << 20, log);
    return log.text();
  }
};

TEST_F(StartProcessTest, LooksAProgramUpInTheGivenPath) {
  std::filesystem::create_directory(folder_ / "a");
  std::filesystem::create_directory(folder_ / "b");
  write_program("a/tool", "#!/bin/sh\necho a\n", 0644);
  write_program("b/tool", "#!/bin/sh\necho b $1\n");
  ProcessRequest tool = request({"tool", "x y"});
  const std::string root = folder_.string();
  tool.environment = {"PATH=" + root + "/none:" + root + "/a:" + root + "/b", mark()};
  EXPECT_EQ(output_of(tool), "b x y\n") << "the one in a/ may not be executed";
  tool.environment = {"PATH=" + root + "/a:" + root + "/none", mark()};
  EXPECT_EQ(output_of(tool), "cannot run tool: Permission denied");
  tool.environment = {"PATH=:" + root, mark()};
  EXPECT_EQ(output_of(tool), "cannot run tool: No such file or directory");
  tool.folder = folder_ / "b";
  EXPECT_EQ(output_of(tool), "b x y\n") << "an empty part is the folder itself";
  EXPECT_EQ(output_of({{"echo", "found"}, folder_, {mark()}, {}, {}}), "found\n") << "without PATH";
}

TEST_F(StartProcessTest, TakesANameWithASlashFromTheFolder) {
  std::filesystem::create_directory(folder_ / "bin");
  write_program("bin/tool", "#!/bin/sh\necho here\n");
  EXPECT_EQ(output_of(request({"bin/tool"})), "here\n");
  EXPECT_EQ(output_of(request({"./tool"})), "cannot run ./tool: No such file or directory");
}

TEST_F(StartProcessTest, GivesAScriptWithoutAFormatToTheShell) {
  write_program("run", "echo $0 $#\n");
  EXPECT_EQ(output_of(request({"./run", "a b", "c"})), "./run 2\n");
}

TEST_F(StartProcessTest, SaysThatAnInterpreterIsMissing) {
  write_program("run", "#!/no/such/interpreter\n");
  EXPECT_EQ(output_of(request({"./run"})), "cannot run ./run: No such file or directory");
}

TEST_F(StartProcessTest, SaysThatArgumentsAreTooLong) {
  EXPECT_EQ(output_of(request({"/bin/true", std::string(4 << 20, 'x')})),
            "cannot run /bin/true: Argument list too long");
}

TEST_F(StartProcessTest, ShowsTheEnd) {
  StartedProcess started = start_process(shell("exit 4"));
  ASSERT_GT(started.pid, 0);
  if (started.end.valid()) {
    pollfd end = {started.end.get(), POLLIN, 0};
    EXPECT_EQ(::poll(&end, 1, 60'000), 1);
  }
  int status = 0;
  EXPECT_EQ(::waitpid(started.pid, &status, 0), started.pid);
  EXPECT_EQ(WEXITSTATUS(status), 4);
}

}  // namespace
}  // namespace plumb

#include "conformance/sandbox/end_processes.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>

#include <vector>

#include "conformance/sandbox/run_fixture.h"
#include "conformance/sandbox/start_process.h"

namespace plumb {
namespace {

class EndProcessesTest : public RunTest {
 protected:
  EndProcessesTest() { ::prctl(PR_SET_CHILD_SUBREAPER, 1); }
  ~EndProcessesTest() override { ::prctl(PR_SET_CHILD_SUBREAPER, 0); }
};

TEST_F(EndProcessesTest, GivesTheStatusOfALeaderThatHasEnded) {
  ProcessTree tree;
  UsageMeter meter;
  const StartedProcess started = start_process(subject({"burn", "50"}));
  while (!has_ended(started.pid)) {
  }
  EXPECT_TRUE(has_ended(started.pid)) << "asking does not wait for it";
  const int status = end_processes(tree, started.pid, meter);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_GE(meter.cpu_seconds(), 0.05);
}

TEST_F(EndProcessesTest, EndsALeaderThatGoesOn) {
  ProcessTree tree;
  UsageMeter meter;
  const StartedProcess started = start_process(subject({"ignore-signals"}));
  EXPECT_FALSE(has_ended(started.pid));
  const int status = end_processes(tree, started.pid, meter);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGKILL);
}

TEST_F(EndProcessesTest, EndsProcessesInManyStates) {
  ProcessTree tree;
  UsageMeter meter;
  const StartedProcess started = start_process(subject({"fork-bomb", "60", "sessions"}));
  // 60 children, and below every fifth of them one more: running, sleeping and stopped ones.
  std::size_t found = 0;
  for (int i = 0; i < 100'000 && found < 73; ++i) found = tree.scan().size();
  EXPECT_EQ(found, 73u);
  end_processes(tree, started.pid, meter);
  EXPECT_TRUE(tree.scan().empty());
}

TEST_F(EndProcessesTest, ReapsAdoptedProcessesOnly) {
  ProcessTree tree;
  UsageMeter meter;
  const StartedProcess started = start_process(shell("(sleep 0.02 & ) ; exit 0"));
  // The leader and, once it has ended, the orphan become zombies; only the orphan is taken away.
  std::vector<ProcessStat> left;
  for (int i = 0; i < 100'000; ++i) {
    left = tree.scan();
    reap_adopted(left, started.pid, meter);
    if (left.size() == 1 && left[0].state == 'Z') break;
  }
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].id.pid, started.pid);
  end_processes(tree, started.pid, meter);
}

}  // namespace
}  // namespace plumb

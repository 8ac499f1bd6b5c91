#include "conformance/sandbox/process_tree.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "conformance/sandbox/run_fixture.h"

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

/// This process adopts orphans meanwhile, so that nothing escapes the tests.
class ProcessTreeTest : public testing::Test {
 protected:
  ProcessTreeTest() { ::prctl(PR_SET_CHILD_SUBREAPER, 1); }
  ~ProcessTreeTest() override { ::prctl(PR_SET_CHILD_SUBREAPER, 0); }

  /// Looks until `count` processes are there: a child's fork takes its time.
  static std::vector<ProcessStat> scan_until(ProcessTree& tree, std::size_t count) {
    std::vector<ProcessStat> found;
    for (int i = 0; i < 10'000 && found.size() != count; ++i) found = tree.scan();
    return found;
  }
};

TEST_F(ProcessTreeTest, FindsDescendantsParentsFirstAndKeepsOrphans) {
  ProcessTree tree;
  EXPECT_TRUE(tree.scan().empty());
  const pid_t child = ::fork();
  if (child == 0) {
    start_waiting_child();
    wait_for_the_end();
  }
  const std::vector<ProcessStat> found = scan_until(tree, 2);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].id.pid, child);
  EXPECT_EQ(found[1].parent, child);
  end_child(child);
  // The grandchild was adopted here. It may be dying of its parent's death, but it is not gone before a wait.
  const std::vector<ProcessStat> orphan = tree.scan();
  ASSERT_EQ(orphan.size(), 1u);
  EXPECT_EQ(orphan[0].id, found[1].id);
  EXPECT_EQ(orphan[0].parent, ::getpid());
  end_child(found[1].id.pid);
  EXPECT_TRUE(tree.scan().empty());
}

TEST_F(ProcessTreeTest, SkipsOlderProcessesAndTheirNewChildren) {
  const pid_t older = start_waiting_child();
  ProcessTree tree;
  const pid_t newer = start_waiting_child();
  const std::vector<ProcessStat> found = tree.scan();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].id.pid, newer);
  end_child(newer);
  end_child(older);
}

TEST_F(ProcessTreeTest, SkipsWhatAnOlderProcessStartsLater) {
  const pid_t older = ::fork();
  if (older == 0) {
    sigset_t go;
    int signal = 0;
    ::sigemptyset(&go);
    ::sigaddset(&go, SIGUSR1);
    ::sigprocmask(SIG_BLOCK, &go, nullptr);
    ::raise(SIGSTOP);
    ::sigwait(&go, &signal);
    start_waiting_child();
    wait_for_the_end();
  }
  ASSERT_EQ(::waitpid(older, nullptr, WUNTRACED), older);
  ProcessTree tree;
  ::kill(older, SIGCONT);
  ::kill(older, SIGUSR1);
  // Looked for in another way, the new one is found.
  pid_t started = 0;
  for (int i = 0; i < 10'000 && started == 0; ++i) {
    EXPECT_TRUE(tree.scan().empty());
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
      const auto stat = read_process_stat(static_cast<pid_t>(std::atol(entry.path().filename().c_str())));
      if (stat && stat->parent == older) started = stat->id.pid;
    }
  }
  ASSERT_NE(started, 0);
  EXPECT_TRUE(tree.scan().empty());
  end_child(older);
  EXPECT_TRUE(tree.scan().empty()) << "adopted here now, it is still not one of the run";
  end_child(started);
}

TEST_F(ProcessTreeTest, SendsASignalToAllThatItFinds) {
  ProcessTree tree;
  const pid_t first = start_waiting_child();
  const pid_t second = start_waiting_child();
  EXPECT_EQ(tree.scan(SIGKILL).size(), 2u);
  int status = 0;
  EXPECT_EQ(::waitpid(first, &status, 0), first);
  EXPECT_EQ(::waitpid(second, &status, 0), second);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_TRUE(tree.scan().empty());
}

TEST_F(ProcessTreeTest, SendsNoSignalToAnotherProcessOfThatNumber) {
  const pid_t child = start_waiting_child();
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

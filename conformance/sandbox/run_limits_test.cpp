#include <gmock/gmock.h>
#include <signal.h>
#include <sys/mman.h>

#include <cstring>
#include <string>

#include "conformance/sandbox/process_memory.h"
#include "conformance/sandbox/run_fixture.h"
#include "conformance/sandbox/run_process.h"

namespace plumb {
namespace {

constexpr std::int64_t kMega = 1 << 20;

// Each limit: subjects that pass it in different ways, and ones that stay below it. Times are compared only in
// the direction that a slow machine cannot turn round.
class RunLimit : public RunTest {
 protected:
  RunOutcome with_cpu(double seconds, const std::vector<std::string>& mode) const {
    ProcessRequest request = subject(mode);
    request.limits.cpu_seconds = seconds;
    return run_process(request);
  }
  RunOutcome with_wall(double seconds, const std::vector<std::string>& mode) const {
    ProcessRequest request = subject(mode);
    request.limits.wall_seconds = seconds;
    return run_process(request);
  }
  RunOutcome with_memory(std::int64_t bytes, const std::vector<std::string>& mode) const {
    ProcessRequest request = subject(mode);
    request.limits.memory_bytes = bytes;
    return run_process(request);
  }
  RunOutcome with_output(std::int64_t bytes, const std::vector<std::string>& mode) const {
    ProcessRequest request = subject(mode);
    request.limits.output_bytes = bytes;
    return run_process(request);
  }
};

void expect_cpu_limit(const RunOutcome& outcome, double limit) {
  EXPECT_EQ(outcome.reason, StopReason::cpu_limit);
  EXPECT_GT(outcome.cpu_seconds, limit);
}

TEST_F(RunLimit, CpuStopsOneBurner) {
  const RunOutcome outcome = with_cpu(0.3, {"burn", "100000"});
  expect_cpu_limit(outcome, 0.3);
  EXPECT_EQ(outcome.signal, SIGKILL);
  EXPECT_EQ(outcome.exit_code, -1);
}

TEST_F(RunLimit, CpuStopsABurnerWithoutDescriptors) {
  expect_cpu_limit(with_cpu(0.3, {"burn-without-descriptors"}), 0.3);
}

TEST_F(RunLimit, CpuCountsShortLivedChildren) {
  expect_cpu_limit(with_cpu(0.3, {"burn-in-children", "100000", "2", "wait"}), 0.3);
}

TEST_F(RunLimit, CpuCountsChildrenThatNobodyWaitsFor) {
  expect_cpu_limit(with_cpu(0.3, {"burn-in-children", "1000", "100", "ignore"}), 0.3);
}

TEST_F(RunLimit, CpuCountsADaemon) { expect_cpu_limit(with_cpu(0.3, {"burn-as-daemon"}), 0.3); }

TEST_F(RunLimit, CpuIsJudgedByWhatWasUsedInTheEnd) {
  // Too short to be seen while it runs: less than the rounding of the kernel's table.
  const RunOutcome outcome = with_cpu(0.004, {"burn", "8"});
  expect_cpu_limit(outcome, 0.004);
}

TEST_F(RunLimit, CpuLeavesAFrugalProgramAlone) {
  const RunOutcome outcome = with_cpu(30, {"burn", "200"});
  EXPECT_EQ(outcome.reason, StopReason::exited);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_GE(outcome.cpu_seconds, 0.2);
}

TEST_F(RunLimit, CpuIsCountedOnce) {
  // Seen alive for several looks, waited for by their parent, then with it: three chances to count twice. The
  // subject's own account lacks only its last steps and those of its children that the kernel charges later.
  const RunOutcome outcome = with_cpu(30, {"burn-in-children", "5", "80", "wait"});
  EXPECT_EQ(outcome.reason, StopReason::exited);
  const double own_account = std::stod(outcome.log);
  EXPECT_GE(own_account, 0.4);
  EXPECT_GE(outcome.cpu_seconds, own_account - 1e-4);
  EXPECT_LT(outcome.cpu_seconds, own_account + 0.3);
}

TEST_F(RunLimit, WallStopsASleeper) {
  ProcessRequest sleeper = shell("sleep 100");
  sleeper.limits.wall_seconds = 0.2;
  const RunOutcome outcome = run_process(sleeper);
  EXPECT_EQ(outcome.reason, StopReason::wall_limit);
  EXPECT_GT(outcome.wall_seconds, 0.2);
}

TEST_F(RunLimit, WallStopsOneThatStoppedItself) {
  const RunOutcome outcome = with_wall(0.2, {"stop-itself"});
  EXPECT_EQ(outcome.reason, StopReason::wall_limit);
  EXPECT_EQ(outcome.signal, SIGKILL);
}

TEST_F(RunLimit, WallStopsOneThatIgnoresSignals) {
  EXPECT_EQ(with_wall(0.2, {"ignore-signals"}).reason, StopReason::wall_limit);
}

TEST_F(RunLimit, WallLeavesAQuickProgramAlone) {
  const RunOutcome outcome = run_process(shell("sleep 0.1"));
  EXPECT_EQ(outcome.reason, StopReason::exited);
  EXPECT_GE(outcome.wall_seconds, 0.1);
}

TEST_F(RunLimit, WallEndsForkBombs) {
  for (const char* kind : {"group", "sessions"}) {
    EXPECT_EQ(with_wall(0.5, {"fork-bomb", "200", kind}).reason, StopReason::wall_limit) << kind;
    EXPECT_EQ(marked_processes(), 0) << kind;
  }
}

TEST_F(RunLimit, WhatAlwaysForksAndExitsIsCaught) {
  // The leader is gone at once, so the run is over and the rest is cleaning up.
  EXPECT_EQ(with_wall(30, {"hop"}).reason, StopReason::exited);
}

TEST_F(RunLimit, ProcessesStopAForkBomb) {
  ProcessRequest bomb = subject({"fork-bomb", "200", "sessions"});
  bomb.limits.processes_and_threads = 100;
  EXPECT_EQ(run_process(bomb).reason, StopReason::process_limit);
}

TEST_F(RunLimit, ProcessesLeaveAFewAlone) {
  ProcessRequest few = shell("sleep 0.1 & sleep 0.1 & wait");
  few.limits.processes_and_threads = 3;
  EXPECT_EQ(run_process(few).reason, StopReason::exited);
}

TEST_F(RunLimit, MemoryStopsOneProcess) {
  const RunOutcome outcome = with_memory(100 * kMega, {"allocate", "150", "1", "hold"});
  EXPECT_EQ(outcome.reason, StopReason::memory_limit);
  EXPECT_GT(outcome.peak_memory_bytes, 100 * kMega);
}

TEST_F(RunLimit, MemoryIsTheSumOfAllProcesses) {
  EXPECT_EQ(with_memory(150 * kMega, {"allocate", "50", "4", "hold"}).reason, StopReason::memory_limit);
}

TEST_F(RunLimit, MemoryCountsSharedMemory) {
  EXPECT_EQ(with_memory(100 * kMega, {"allocate-shared-memory", "150"}).reason, StopReason::memory_limit);
}

TEST_F(RunLimit, MemoryIsSeenWithoutAMainThread) {
  EXPECT_EQ(with_memory(100 * kMega, {"allocate-without-main-thread", "150"}).reason, StopReason::memory_limit);
}

TEST_F(RunLimit, MemoryIsSeenInAProgramThatEndsAtOnce) {
  // Above the limit only for its last moments, which looks at it mostly miss; then the kernel's record tells,
  // as it is more than what this process itself holds, by far more than the 16 MiB of growth allowed for.
  const std::int64_t limit = own_resident_bytes() / kMega + 100;
  const RunOutcome outcome = with_memory(limit * kMega, {"allocate", std::to_string(limit + 4), "1", "end"});
  EXPECT_EQ(outcome.reason, StopReason::memory_limit);
  EXPECT_GT(outcome.peak_memory_bytes, limit * kMega);
}

TEST_F(RunLimit, MemoryLeavesAFrugalProgramAlone) {
  const RunOutcome outcome = with_memory(100 * kMega, {"allocate", "50", "1", "shared"});
  EXPECT_EQ(outcome.reason, StopReason::exited);
  EXPECT_GE(outcome.peak_memory_bytes, 50 * kMega);
  EXPECT_LT(outcome.peak_memory_bytes, 100 * kMega);
}

TEST_F(RunLimit, MemoryOfAForkIsNotCountedAgain) {
  const RunOutcome outcome = with_memory(200 * kMega, {"allocate", "80", "5", "shared"});
  EXPECT_EQ(outcome.reason, StopReason::exited);
  EXPECT_LE(outcome.peak_memory_bytes, 200 * kMega);
}

TEST_F(RunLimit, MemoryOfTheCallerIsNotTheSubjects) {
  constexpr std::size_t kOwn = 300 * kMega;
  void* const own = ::mmap(nullptr, kOwn, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(own, MAP_FAILED);
  std::memset(own, 1, kOwn);
  const RunOutcome outcome = with_memory(100 * kMega, {"burn", "1"});
  ::munmap(own, kOwn);
  EXPECT_EQ(outcome.reason, StopReason::exited);
  EXPECT_LT(outcome.peak_memory_bytes, 100 * kMega);
}

TEST_F(RunLimit, OutputStopsALargeFile) {
  const RunOutcome outcome = with_output(kMega, {"write-file", "out", "5000"});
  EXPECT_EQ(outcome.reason, StopReason::output_limit) << "although the subject ignores SIGXFSZ and exits with 0";
  EXPECT_GT(outcome.output_bytes, kMega);
  EXPECT_LT(outcome.output_bytes, 2 * kMega);
}

TEST_F(RunLimit, OutputStopsManyFilesTogether) {
  EXPECT_EQ(with_output(kMega, {"write-files", "100", "20"}).reason, StopReason::output_limit);
}

TEST_F(RunLimit, OutputStopsTooManyFiles) {
  const RunOutcome outcome = with_output(1000 * kMega, {"write-files", "100001", "0"});
  EXPECT_EQ(outcome.reason, StopReason::output_limit);
}

TEST_F(RunLimit, OutputStopsASparseFile) {
  const RunOutcome outcome = with_output(kMega, {"write-sparse"});
  EXPECT_EQ(outcome.reason, StopReason::output_limit);
  EXPECT_EQ(outcome.signal, SIGXFSZ);
}

TEST_F(RunLimit, OutputLeavesASmallFileAlone) {
  const RunOutcome outcome = with_output(kMega, {"write-file", "out", "100"});
  EXPECT_EQ(outcome.reason, StopReason::exited);
  EXPECT_GE(outcome.output_bytes, 100 * 1024);
  EXPECT_LT(outcome.output_bytes, kMega);
}

}  // namespace
}  // namespace plumb

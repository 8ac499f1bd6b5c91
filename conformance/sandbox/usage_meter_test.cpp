#include "conformance/sandbox/usage_meter.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <vector>

namespace plumb {
namespace {

// In ticks of the kernel's table, user time only unless said otherwise.
ProcessStat process(pid_t pid, std::int64_t own, std::int64_t children = 0, std::uint64_t start = 1) {
  ProcessStat stat;
  stat.id = {pid, start};
  stat.user = own;
  stat.children_user = children;
  return stat;
}

class UsageMeterTest : public testing::Test {
 protected:
  double ticks() const { return meter_.cpu_seconds() * static_cast<double>(::sysconf(_SC_CLK_TCK)); }
  void look(const std::vector<ProcessStat>& alive) { meter_.sample(alive); }
  void reap(std::int64_t ticks, long kilobytes = 0) {
    rusage usage = {};
    const std::int64_t microseconds = ticks * 1'000'000 / ::sysconf(_SC_CLK_TCK);
    usage.ru_utime = {microseconds / 1'000'000, microseconds % 1'000'000};
    usage.ru_maxrss = kilobytes;
    meter_.add_reaped(usage);
  }
  UsageMeter meter_;
};

TEST_F(UsageMeterTest, StartsAtZero) {
  EXPECT_EQ(meter_.cpu_seconds(), 0);
  EXPECT_EQ(meter_.largest_resident_bytes(), 0);
}

TEST_F(UsageMeterTest, AddsTheLivingAndTheReaped) {
  ProcessStat both = process(10, 5, 7);
  both.system = 3;
  both.children_system = 2;
  look({both, process(11, 20)});
  EXPECT_DOUBLE_EQ(ticks(), 37);
  reap(100);
  EXPECT_DOUBLE_EQ(ticks(), 100) << "the reaped one may be one of the living of the last look";
  look({both});
  EXPECT_DOUBLE_EQ(ticks(), 117);
}

TEST_F(UsageMeterTest, CountsAChildThatItsParentWaitedForOnce) {
  look({process(10, 0), process(11, 50)});
  look({process(10, 0, 52)});
  look({process(10, 0, 52)});
  EXPECT_DOUBLE_EQ(ticks(), 52);
}

TEST_F(UsageMeterTest, CountsAChildWaitedForDuringALookOnce) {
  // The parent is read, then the child ends and is waited for, and is not there any more when its turn comes.
  look({process(10, 0), process(11, 50)});
  look({process(10, 0, 0)});
  look({process(10, 0, 50)});
  look({process(10, 0, 50)});
  EXPECT_DOUBLE_EQ(ticks(), 50);
}

TEST_F(UsageMeterTest, CountsAChildReapedHereOnce) {
  look({process(10, 0), process(11, 50)});
  reap(51);
  look({process(10, 0)});
  look({process(10, 0)});
  EXPECT_DOUBLE_EQ(ticks(), 51);
}

TEST_F(UsageMeterTest, FollowsTimesThatTravelUpSeveralParents) {
  look({process(10, 0), process(11, 3), process(12, 50)});
  look({process(10, 0, 53)});  // 11 waited for 12, then 10 for 11.
  reap(53);                    // Then 10 was waited for here.
  look({});
  look({});
  EXPECT_DOUBLE_EQ(ticks(), 53);
}

TEST_F(UsageMeterTest, KeepsWhatAnIgnoredChildHad) {
  for (int i = 0; i < 10; ++i) look({process(10, 0), process(20 + i, 5)});
  look({process(10, 0)});
  look({process(10, 0)});
  EXPECT_DOUBLE_EQ(ticks(), 50);
}

TEST_F(UsageMeterTest, TellsANumberUsedAgainApart) {
  look({process(10, 0), process(11, 5, 0, 1)});
  look({process(10, 0, 5), process(11, 7, 0, 2)});
  look({process(10, 0, 5), process(11, 8, 0, 2)});
  EXPECT_DOUBLE_EQ(ticks(), 13);
}

TEST_F(UsageMeterTest, NeverFalls) {
  look({process(10, 10), process(11, 50)});
  EXPECT_DOUBLE_EQ(ticks(), 60);
  look({process(10, 10)});
  EXPECT_DOUBLE_EQ(ticks(), 60);
}

TEST_F(UsageMeterTest, RemembersTheLargestProcess) {
  reap(0, 100);
  reap(0, 300);
  reap(0, 200);
  EXPECT_EQ(meter_.largest_resident_bytes(), 300 * 1024);
}

}  // namespace
}  // namespace plumb

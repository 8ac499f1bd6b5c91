#include "conformance/sandbox/process_memory.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <vector>

#include "conformance/sandbox/run_fixture.h"

namespace plumb {
namespace {

constexpr std::int64_t kMega = 1 << 20;
// What a process may hold or change by itself beyond what a test asks for; sanitizers need the most.
constexpr std::int64_t kSlack = 20 * kMega;

/// Memory that the kernel itself fills with pages: were they written here, the thread sanitizer would take four
/// times as much beside them.
class Block {
 public:
  Block(std::int64_t bytes, int sharing) : bytes_(static_cast<std::size_t>(bytes)) {
    memory_ = reinterpret_cast<void*>(
        ::syscall(SYS_mmap, nullptr, bytes_, PROT_READ | PROT_WRITE, sharing | MAP_ANONYMOUS | MAP_POPULATE, -1, 0));
    EXPECT_NE(memory_, MAP_FAILED);
  }
  Block(const Block&) = delete;
  Block& operator=(const Block&) = delete;
  ~Block() { ::syscall(SYS_munmap, memory_, bytes_); }

 private:
  std::size_t bytes_;
  void* memory_;
};

ProcessStat self() { return read_process_stat(::getpid()).value(); }

TEST(MemoryOf, CountsPrivateAndSharedPages) {
  for (const int sharing : {MAP_PRIVATE, MAP_SHARED}) {
    const std::int64_t before = memory_of(self()).counted;
    const Block block(200 * kMega, sharing);
    EXPECT_NEAR(static_cast<double>(memory_of(self()).counted - before), 200.0 * kMega, kSlack);
  }
  EXPECT_GT(memory_of(self()).file_pages, 0) << "at least the program itself";
}

TEST(MemoryOf, IsNothingForAZombie) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  siginfo_t info;
  ASSERT_EQ(::waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOWAIT), 0);
  const auto stat = read_process_stat(child);
  ASSERT_TRUE(stat);
  EXPECT_EQ(memory_of(*stat).counted, 0);
  EXPECT_EQ(memory_without_sharing(std::vector{*stat}), 0);
  EXPECT_EQ(::waitpid(child, nullptr, 0), child);
  EXPECT_EQ(memory_of(*stat).counted, 0) << "nor for one that is gone";
}

TEST(MemoryWithoutSharing, CountsAForkedPageOnce) {
  const std::int64_t before = memory_without_sharing(std::vector{self()});
  const Block block(200 * kMega, MAP_PRIVATE);
  const pid_t child = start_waiting_child();
  const std::vector both{self(), read_process_stat(child).value()};
  EXPECT_GE(memory_of(both[0]).counted + memory_of(both[1]).counted, 400 * kMega) << "the quick sum";
  EXPECT_NEAR(static_cast<double>(memory_without_sharing(both) - before), 200.0 * kMega, kSlack);
  end_child(child);
}

TEST(OwnResidentBytes, GrowsWithWhatIsTouched) {
  const std::int64_t before = own_resident_bytes();
  EXPECT_GT(before, 0);
  const Block block(200 * kMega, MAP_PRIVATE);
  EXPECT_NEAR(static_cast<double>(own_resident_bytes() - before), 200.0 * kMega, kSlack);
}

}  // namespace
}  // namespace plumb

#include "conformance/sandbox/log_capture.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <limits>
#include <string>

#include "conformance/sandbox/file_descriptor.h"

namespace plumb {
namespace {

TEST(LogCapture, KeepsAllUpToTheCap) {
  LogCapture log(6);
  log.append("abc");
  log.append(std::string_view("d\0f", 3));
  EXPECT_EQ(log.dropped(), 0);
  EXPECT_EQ(log.text(), std::string("abcd\0f", 6));
}

TEST(LogCapture, KeepsTheFirstAndTheLastHalf) {
  LogCapture log(6);
  log.append("abcdefg");
  EXPECT_EQ(log.dropped(), 1);
  EXPECT_EQ(log.text(), "abc\n[1 byte dropped]\nefg");
  log.append("hi");
  EXPECT_EQ(log.text(), "abc\n[3 bytes dropped]\nghi");
}

TEST(LogCapture, IsTheSameHoweverTheBytesArrive) {
  std::string all;
  for (int i = 0; i < 1000; ++i) all += static_cast<char>('a' + i % 26);
  int compared = 0;
  for (const std::int64_t cap : {0, 1, 2, 3, 10, 64, 999, 1000, 2000}) {
    LogCapture whole(cap);
    whole.append(all);
    for (const std::size_t piece : {1, 3, 7, 64, 500, 999}) {
      LogCapture log(cap);
      for (std::size_t at = 0; at < all.size(); at += piece) log.append(std::string_view(all).substr(at, piece));
      EXPECT_EQ(log.text(), whole.text()) << "cap " << cap << ", pieces of " << piece;
      EXPECT_EQ(log.dropped(), std::max<std::int64_t>(1000 - cap, 0));
      ++compared;
    }
  }
  EXPECT_EQ(compared, 54);
}

TEST(LogCapture, KeepsNothingWithoutACap) {
  LogCapture log(0);
  log.append("abc");
  EXPECT_EQ(log.text(), "[3 bytes dropped]\n");
  EXPECT_EQ(LogCapture(-5).text(), "");
}

TEST(Drain, TakesWhatIsThereAndSeesTheEnd) {
  std::array<int, 2> ends;
  ASSERT_EQ(::pipe2(ends.data(), O_NONBLOCK | O_CLOEXEC), 0);
  const FileDescriptor read(ends[0]);
  FileDescriptor write(ends[1]);
  LogCapture log(100);
  EXPECT_TRUE(drain(read.get(), 1000, log)) << "an empty pipe is not closed";
  ASSERT_EQ(::write(write.get(), "text", 4), 4);
  EXPECT_TRUE(drain(read.get(), 1000, log));
  EXPECT_EQ(log.text(), "text");
  write.reset();
  EXPECT_FALSE(drain(read.get(), 1000, log));
}

TEST(Drain, DoesNotFollowAnEndlessWriter) {
  const FileDescriptor zeros(::open("/dev/zero", O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  LogCapture log(10);
  EXPECT_TRUE(drain(zeros.get(), 1 << 20, log));
  EXPECT_EQ(log.dropped(), (1 << 20) - 10);
  EXPECT_FALSE(drain(-1, 10, log));
}

}  // namespace
}  // namespace plumb

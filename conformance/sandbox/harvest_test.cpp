#include "conformance/sandbox/harvest.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>

#include "conformance/sandbox/file_descriptor.h"
#include "conformance/sandbox/run_fixture.h"

namespace plumb {
namespace {

class HarvestTest : public FolderTest {
 protected:
  HarvestTest() : out_(folder_ / "out"), destination_(folder_ / "kept") { std::filesystem::create_directory(out_); }

  HarvestResult harvest_from_out(const std::string& path, std::int64_t max_bytes = 1000) const {
    return harvest(out_, path, max_bytes, destination_);
  }
  /// Refused with that status, a sentence about it, and nothing left at the destination.
  void expect_refused(const HarvestResult& result, HarvestStatus status) const {
    EXPECT_STREQ(to_string(result.status), to_string(status)) << result.sentence;
    EXPECT_FALSE(result.sentence.empty());
    EXPECT_EQ(result.bytes, 0);
    EXPECT_FALSE(std::filesystem::exists(destination_));
    EXPECT_FALSE(std::filesystem::exists(destination_.string() + ".partial"));
  }
  std::string kept() const {
    std::ifstream file(destination_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }

  std::filesystem::path out_;
  std::filesystem::path destination_;
};

TEST_F(HarvestTest, CopiesAFileUpToTheLastByteAllowed) {
  write("out/picture.png", std::string(1000, 'x'));
  const HarvestResult result = harvest_from_out("picture.png");
  EXPECT_EQ(result.status, HarvestStatus::copied) << result.sentence;
  EXPECT_EQ(result.bytes, 1000);
  EXPECT_EQ(result.sentence, "picture.png has 1000 bytes");
  EXPECT_EQ(kept(), std::string(1000, 'x'));
}

TEST_F(HarvestTest, CopiesAllBytesOfALargeFile) {
  std::string text;
  for (int i = 0; i < 1'000'000; ++i) text += static_cast<char>(i * 7 + i / 256);
  std::filesystem::create_directories(out_ / "a" / "b");
  write("out/a/b/large", text);
  EXPECT_EQ(harvest_from_out("a/b/large", 1 << 30).bytes, 1'000'000);
  EXPECT_EQ(kept(), text);
}

TEST_F(HarvestTest, ReplacesWhatIsThereOnlyWhenItCopies) {
  write("kept", "before");
  EXPECT_EQ(harvest_from_out("none").status, HarvestStatus::missing);
  EXPECT_EQ(kept(), "before");
  write("out/new", "");
  EXPECT_EQ(harvest_from_out("new", 0).status, HarvestStatus::copied);
  EXPECT_EQ(kept(), "");
}

TEST_F(HarvestTest, MissesAFileThatIsNotThere) {
  expect_refused(harvest_from_out("none"), HarvestStatus::missing);
  expect_refused(harvest_from_out("no/way"), HarvestStatus::missing);
  write("out/file", "x");
  expect_refused(harvest_from_out("file/below"), HarvestStatus::missing);
  expect_refused(harvest_from_out(std::string(300, 'n')), HarvestStatus::missing);
  expect_refused(harvest(folder_ / "gone", "file", 10, destination_), HarvestStatus::missing);
}

TEST_F(HarvestTest, RefusesSymbolicLinks) {
  write("secret", "x");
  write("out/real", "x");
  std::filesystem::create_symlink("../secret", out_ / "away");
  std::filesystem::create_symlink("real", out_ / "inside");
  std::filesystem::create_symlink("nowhere", out_ / "dangling");
  for (const char* name : {"away", "inside", "dangling"}) expect_refused(harvest_from_out(name), HarvestStatus::link);
}

TEST_F(HarvestTest, RefusesASymbolicLinkOnTheWay) {
  std::filesystem::create_directory(folder_ / "elsewhere");
  write("elsewhere/file", "x");
  std::filesystem::create_symlink("../elsewhere", out_ / "sub");
  expect_refused(harvest_from_out("sub/file"), HarvestStatus::link);
  std::filesystem::create_directory(out_ / "inside");
  write("out/inside/file", "x");
  std::filesystem::create_symlink("inside", out_ / "alias");
  expect_refused(harvest_from_out("alias/file"), HarvestStatus::link);
  std::filesystem::create_symlink("elsewhere", folder_ / "replaced");
  expect_refused(harvest(folder_ / "replaced", "file", 10, destination_), HarvestStatus::link);
}

TEST_F(HarvestTest, RefusesHardLinks) {
  std::filesystem::create_hard_link(write("secret", "x"), out_ / "linked");
  expect_refused(harvest_from_out("linked"), HarvestStatus::link);
}

TEST_F(HarvestTest, RefusesWaysOut) {
  write("secret", "x");
  std::filesystem::create_directory(out_ / "sub");
  expect_refused(harvest_from_out("../secret"), HarvestStatus::link);
  expect_refused(harvest_from_out("sub/../../secret"), HarvestStatus::link);
  expect_refused(harvest_from_out((folder_ / "secret").string()), HarvestStatus::link);
  expect_refused(harvest(folder_, "/proc/self/environ", 1 << 20, destination_), HarvestStatus::link);
  write("out/inside", "x");
  EXPECT_EQ(harvest_from_out("sub/../inside").status, HarvestStatus::copied);
}

TEST_F(HarvestTest, RefusesWhatIsNoFile) {
  ASSERT_EQ(::mkfifo((out_ / "pipe").c_str(), 0666), 0);
  expect_refused(harvest_from_out("pipe"), HarvestStatus::not_regular);
  std::filesystem::create_directory(out_ / "folder");
  expect_refused(harvest_from_out("folder"), HarvestStatus::not_regular);
  expect_refused(harvest_from_out("."), HarvestStatus::not_regular);
  const FileDescriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  (out_ / "socket").string().copy(address.sun_path, sizeof address.sun_path - 1);
  ASSERT_EQ(::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  expect_refused(harvest_from_out("socket"), HarvestStatus::not_regular);
  expect_refused(harvest("/dev", "zero", 10, destination_), HarvestStatus::not_regular);
}

TEST_F(HarvestTest, RefusesALargeFile) {
  write("out/large", std::string(1001, 'x'));
  expect_refused(harvest_from_out("large"), HarvestStatus::too_large);
  std::filesystem::resize_file(write("out/sparse", ""), std::uintmax_t{1} << 40);
  expect_refused(harvest_from_out("sparse", 1 << 30), HarvestStatus::too_large);
}

TEST_F(HarvestTest, RefusesAFileThatIsLargerThanItSays) {
  // The kernel's own files have length 0 and yet much to read: like a file that has grown since it was looked at.
  const std::filesystem::path self = "/proc/" + std::to_string(::getpid());
  expect_refused(harvest(self, "status", 16, destination_), HarvestStatus::too_large);
  const HarvestResult whole = harvest(self, "status", 1 << 20, destination_);
  EXPECT_EQ(whole.status, HarvestStatus::copied);
  EXPECT_GT(whole.bytes, 16);
  EXPECT_EQ(static_cast<std::int64_t>(kept().size()), whole.bytes);
}

TEST_F(HarvestTest, NeverCopiesMoreThanAllowedFromAGrowingFile) {
  constexpr std::int64_t kMaxBytes = 3 << 20;
  int copied = 0;
  int refused = 0;
  for (int round = 0; round < 20; ++round) {
    write("out/growing", std::string(1 << 20, 'x'));
    std::atomic<bool> stop = false;
    std::thread writer([&] {
      std::ofstream file(out_ / "growing", std::ios::binary | std::ios::app);
      const std::string block(1 << 16, 'y');
      for (int i = 0; i < 200 && !stop; ++i)
        file.write(block.data(), static_cast<std::streamsize>(block.size())).flush();
    });
    const HarvestResult result = harvest_from_out("growing", kMaxBytes);
    stop = true;
    writer.join();
    if (result.status == HarvestStatus::copied) {
      ++copied;
      EXPECT_LE(static_cast<std::int64_t>(kept().size()), kMaxBytes);
      EXPECT_EQ(static_cast<std::int64_t>(kept().size()), result.bytes);
      std::filesystem::remove(destination_);
    } else {
      ++refused;
      expect_refused(result, HarvestStatus::too_large);
    }
  }
  EXPECT_EQ(copied + refused, 20);
}

TEST_F(HarvestTest, NamesThePathWithoutControlCharacters) {
  EXPECT_EQ(harvest_from_out("a\nb\x1b[31m").sentence, "a?b?[31m does not exist");
}

TEST_F(HarvestTest, ThrowsForFaultsOfOurOwn) {
  write("out/file", "x");
  EXPECT_THROW(harvest(out_, "file", 10, folder_ / "no" / "such" / "folder"), std::system_error);
  EXPECT_THROW(harvest(out_, "file", 10, out_), std::system_error) << "a folder stands there";
  EXPECT_THROW(harvest(out_, "", 10, destination_), std::invalid_argument);
  EXPECT_THROW(harvest(out_, "file", -1, destination_), std::invalid_argument);
}

}  // namespace
}  // namespace plumb

#include "conformance/sandbox/folder_size.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <string>
#include <system_error>

#include "conformance/sandbox/file_descriptor.h"
#include "conformance/sandbox/run_fixture.h"

namespace plumb {
namespace {

using FolderSizeTest = FolderTest;

TEST_F(FolderSizeTest, OfAnEmptyFolderIsZero) {
  const FolderSize size = FolderWatch(folder_).measure();
  EXPECT_EQ(size.bytes, 0);
  EXPECT_EQ(size.entries, 0);
  EXPECT_TRUE(size.complete);
}

TEST_F(FolderSizeTest, AddsFilesOfAllDepths) {
  const FolderWatch watch(folder_);
  write("a", std::string(100'000, 'x'));
  std::filesystem::create_directories(folder_ / "b" / "c");
  write("b/c/d", std::string(200'000, 'x'));
  const FolderSize size = watch.measure();
  EXPECT_EQ(size.entries, 4);
  EXPECT_GE(size.bytes, 300'000);
  EXPECT_LT(size.bytes, 300'000 + 2 * 65'536) << "blocks of the file system are no larger";
  EXPECT_TRUE(size.complete);
}

TEST_F(FolderSizeTest, CountsAHoleByItsLength) {
  std::filesystem::resize_file(write("sparse", ""), std::uintmax_t{1} << 40);
  std::filesystem::resize_file(write("another", ""), std::uintmax_t{1} << 40);
  EXPECT_EQ(FolderWatch(folder_).measure().bytes, std::int64_t{2} << 40);
}

TEST_F(FolderSizeTest, CountsRoomBeyondTheLength) {
  const FileDescriptor file(::open((folder_ / "a").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644));
  if (::fallocate(file.get(), FALLOC_FL_KEEP_SIZE, 0, 1 << 20) != 0) {
    GTEST_SKIP() << "this file system does not preallocate";
  }
  EXPECT_GE(FolderWatch(folder_).measure().bytes, 1 << 20);
}

TEST_F(FolderSizeTest, CountsAHardLinkOnce) {
  std::filesystem::create_hard_link(write("a", std::string(1 << 20, 'x')), folder_ / "b");
  const FolderSize size = FolderWatch(folder_).measure();
  EXPECT_LT(size.bytes, 2 << 20);
  EXPECT_EQ(size.entries, 2);
}

TEST_F(FolderSizeTest, DoesNotFollowLinks) {
  std::filesystem::create_directory(folder_ / "out");
  write("outside", std::string(1 << 20, 'x'));
  std::filesystem::create_symlink("../outside", folder_ / "out" / "file");
  std::filesystem::create_symlink("..", folder_ / "out" / "folder");
  ASSERT_EQ(::mkfifo((folder_ / "out" / "pipe").c_str(), 0600), 0);
  const FolderSize size = FolderWatch(folder_ / "out").measure();
  EXPECT_EQ(size.bytes, 0);
  EXPECT_EQ(size.entries, 3);
  EXPECT_TRUE(size.complete);
}

TEST_F(FolderSizeTest, GivesUpAtTooManyEntries) {
  for (int i = 0; i < 6; ++i) write("file" + std::to_string(i), "");
  EXPECT_TRUE(FolderWatch(folder_, 6).measure().complete);
  EXPECT_FALSE(FolderWatch(folder_, 5).measure().complete);
}

TEST_F(FolderSizeTest, GivesUpWhereFoldersAreTooDeep) {
  std::filesystem::path path = folder_;
  for (int depth = 1; depth < FolderWatch::kMaxDepth; ++depth) path /= "d";
  std::filesystem::create_directories(path);
  EXPECT_TRUE(FolderWatch(folder_).measure().complete);
  std::filesystem::create_directories(path / "d");
  EXPECT_FALSE(FolderWatch(folder_).measure().complete);
}

TEST_F(FolderSizeTest, GivesUpAtAFolderThatHidesItsFiles) {
  std::filesystem::create_directory(folder_ / "hidden");
  ASSERT_EQ(::chmod((folder_ / "hidden").c_str(), 0300), 0);
  ASSERT_EQ(::chmod(folder_.c_str(), 0755), 0);
  // Nothing is hidden from root, who looks as nobody (65534).
  const bool root = ::geteuid() == 0;
  if (root) {
    ASSERT_EQ(::seteuid(65534), 0);
  }
  const bool complete = FolderWatch(folder_).measure().complete;
  if (root) {
    ASSERT_EQ(::seteuid(0), 0);
  }
  EXPECT_FALSE(complete);
}

TEST_F(FolderSizeTest, HoldsTheFolderNotItsName) {
  std::filesystem::create_directory(folder_ / "out");
  std::filesystem::create_directory(folder_ / "empty");
  const FolderWatch watch(folder_ / "out");
  write("out/file", std::string(1000, 'x'));
  std::filesystem::rename(folder_ / "out", folder_ / "moved");
  std::filesystem::create_symlink("empty", folder_ / "out");
  EXPECT_GE(watch.measure().bytes, 1000);
  std::filesystem::remove_all(folder_ / "moved");
  EXPECT_EQ(watch.measure().bytes, 0);
  EXPECT_TRUE(watch.measure().complete);
}

TEST_F(FolderSizeTest, NeedsAFolder) {
  EXPECT_THROW(FolderWatch(folder_ / "none"), std::system_error);
  EXPECT_THROW(FolderWatch{write("file", "")}, std::system_error);
}

}  // namespace
}  // namespace plumb

#include "renderer/image/staged_file.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>

#include "renderer/image/picture_bytes_for_tests.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

using ::testing::HasSubstr;

/// The text of the InputError; empty if the file was written.
std::string refusal(const std::filesystem::path& file, const std::string& bytes = "new") {
  try {
    write_file_staged(file, bytes);
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with(file.string() + ": cannot write the file")) << error.what();
    return error.what();
  }
  return "";
}

bool partial_exists(const std::filesystem::path& file) { return std::filesystem::exists(file.string() + ".partial"); }

TEST(StagedFile, IsWrittenWholeAndReplacesAnOlderOne) {
  const auto file = picture_test_file("out.bin");
  const std::string bytes("a\0b\r\n\xff", 6);
  write_file_staged(file, bytes);
  EXPECT_EQ(bytes_of(file), bytes);
  write_file_staged(file, "");
  EXPECT_EQ(bytes_of(file), "");
  EXPECT_FALSE(partial_exists(file));
}

TEST(StagedFile, NameWithoutAFolderMeansTheCurrentOne) {
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(picture_test_file("x").parent_path());
  write_file_staged("plain.bin", "1");
  EXPECT_EQ(bytes_of("plain.bin"), "1");
  std::filesystem::current_path(before);
}

TEST(StagedFile, AFolderIsNoFile) {
  std::filesystem::create_directories(picture_test_file("folder"));
  EXPECT_THAT(refusal(picture_test_file("folder")), HasSubstr("this is a folder"));
  EXPECT_THAT(refusal(picture_test_file("folder/")), HasSubstr("this is a folder"));
}

TEST(StagedFile, TheFolderMustExist) {
  EXPECT_THAT(refusal(picture_test_file("none/out.bin")), HasSubstr("does not exist"));
  write_file_staged(picture_test_file("file"), "x");
  EXPECT_THAT(refusal(picture_test_file("file/out.bin")), HasSubstr("does not exist")) << "a file is no folder";
}

TEST(StagedFile, AnUnwritableFolderIsRefused) {
  // Not even root may make a file here.
  const std::string message = refusal("/proc/self/plumb.bin");
  EXPECT_NE(message, "");
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST(StagedFile, FailureOnTheWayLeavesTheOldFileAlone) {
  const auto file = picture_test_file("kept.bin");
  write_file_staged(file, "old");
  // A limit on the size of files stands for a full disk.
  const auto old_action = std::signal(SIGXFSZ, SIG_IGN);
  rlimit old_limit{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old_limit), 0);
  rlimit small = old_limit;
  small.rlim_cur = 4096;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string message = refusal(file, std::string(1 << 20, 'x'));
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &old_limit), 0);
  std::signal(SIGXFSZ, old_action);
  EXPECT_THAT(message, HasSubstr("File too large"));
  EXPECT_EQ(bytes_of(file), "old");
  EXPECT_FALSE(partial_exists(file)) << "nothing half-written stays";
}

TEST(StagedFile, APartialFileThatIsInTheWayIsAnError) {
  const auto file = picture_test_file("blocked.bin");
  write_file_staged(file, "old");
  std::filesystem::create_directories(file.string() + ".partial/inner");
  EXPECT_NE(refusal(file), "");
  EXPECT_EQ(bytes_of(file), "old");
}

TEST(StagedFile, CanBeAskedBeforehand) {
  EXPECT_NO_THROW(require_writable(picture_test_file("later.bin")));
  EXPECT_FALSE(std::filesystem::exists(picture_test_file("later.bin"))) << "asking makes no file";
  EXPECT_THROW(require_writable(picture_test_file("none/later.bin")), InputError);
  EXPECT_THROW(require_writable(picture_test_file("x").parent_path()), InputError);
}

}  // namespace
}  // namespace plumb

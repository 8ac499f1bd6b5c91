#include "conformance/diagnosis/fingerprint.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::SizeIs;

class FingerprintFiles : public ::testing::Test {
 protected:
  void SetUp() override { fs::remove_all(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string bytes(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  static std::string message(const fs::path& folder) {
    try {
      read_fingerprint(folder);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  const Fingerprint fingerprint_{
      "rows-lost",
      "Rows are lost",
      "Look at the last row.",
      "camera",
      {"one", "two"},
      {{"sphere", StoredPicture({1, 2, 3, 4, 5, 6}, 2, 1)}, {"glass", StoredPicture({9, 8, 7}, 1, 1)}},
      {"mesh"},
      true,
      {}};
  const fs::path folder_ = fs::temp_directory_path() / ("plumb-fingerprints-" + std::to_string(::getpid()));
};

TEST_F(FingerprintFiles, AreReadAsTheyWereWritten) {
  write_fingerprint(fingerprint_, folder_ / "rows-lost");
  const std::vector<Fingerprint> all = read_fingerprints(folder_);
  ASSERT_THAT(all, SizeIs(1));
  EXPECT_EQ(all[0].id, fingerprint_.id);
  EXPECT_EQ(all[0].name, fingerprint_.name);
  EXPECT_EQ(all[0].hint, fingerprint_.hint);
  EXPECT_EQ(all[0].step, fingerprint_.step);
  EXPECT_EQ(all[0].parts, fingerprint_.parts);
  EXPECT_EQ(all[0].no_picture, fingerprint_.no_picture);
  EXPECT_EQ(all[0].in_places, fingerprint_.in_places);
  ASSERT_THAT(all[0].pictures, SizeIs(2));
  EXPECT_EQ(all[0].pictures.at("sphere").levels(2, 1), (std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(all[0].pictures.at("glass").levels(1, 1), (std::vector<std::uint8_t>{9, 8, 7}));
}

TEST_F(FingerprintFiles, KeepWhatTheMistakeDoesToEveryPicture) {
  Fingerprint changing = fingerprint_;
  changing.change = PictureChange{PictureChange::Move::red_blue, {}};
  changing.change->table[7] = 200;
  write_fingerprint(changing, folder_ / "changing");
  const Fingerprint read = read_fingerprint(folder_ / "changing");
  ASSERT_TRUE(read.change);
  EXPECT_EQ(read.change->move, PictureChange::Move::red_blue);
  EXPECT_EQ(read.change->table, changing.change->table);

  std::string text = bytes(folder_ / "changing" / "mistake.json");
  text.replace(text.find("red-blue"), 8, "sideways");
  std::ofstream(folder_ / "changing" / "mistake.json") << text;
  EXPECT_THAT(message(folder_ / "changing"), HasSubstr("is 'sideways', expected one of none, left-right"));
}

TEST_F(FingerprintFiles, HaveTheSameBytesForTheSameFingerprint) {
  write_fingerprint(fingerprint_, folder_ / "rows-lost");
  const Fingerprint read = read_fingerprint(folder_ / "rows-lost");
  write_fingerprint(read, folder_ / "again");
  int files = 0;
  for (const auto& entry : fs::directory_iterator(folder_ / "rows-lost")) {
    EXPECT_EQ(bytes(entry.path()), bytes(folder_ / "again" / entry.path().filename())) << entry.path();
    ++files;
  }
  EXPECT_EQ(files, 3);
}

TEST_F(FingerprintFiles, AreRefusedWhereTheyCannotBeUsed) {
  EXPECT_THAT(message(folder_ / "nothing"), HasSubstr("mistake.json: cannot be opened"));
  write_fingerprint(fingerprint_, folder_ / "rows-lost");
  std::ofstream(folder_ / "rows-lost" / "mistake.json") << "{";
  EXPECT_THAT(message(folder_ / "rows-lost"), HasSubstr("is no JSON"));
  std::ofstream(folder_ / "rows-lost" / "mistake.json") << R"({"schema": 1})";
  EXPECT_THAT(message(folder_ / "rows-lost"), HasSubstr("has the schema 1, expected 2"));
  std::ofstream(folder_ / "rows-lost" / "mistake.json") << R"({"schema": 2, "name": 3})";
  EXPECT_THAT(message(folder_ / "rows-lost"), HasSubstr("is no description of a known mistake"));
}

TEST_F(FingerprintFiles, PicturesOfAnotherSizeAreRefused) {
  write_fingerprint(fingerprint_, folder_ / "rows-lost");
  const StoredPicture picture(folder_ / "rows-lost" / "sphere.png");
  EXPECT_THROW(picture.levels(1, 2), InputError);
  EXPECT_THROW(StoredPicture(folder_ / "rows-lost" / "missing.png").levels(1, 2), InputError);
}

TEST_F(FingerprintFiles, NoFolderHoldsNone) { EXPECT_THAT(read_fingerprints(folder_ / "nothing"), SizeIs(0)); }

}  // namespace
}  // namespace plumb

#include "conformance/compare/judge_picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/resource.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "renderer/image/write_image.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

std::string from_hex(const std::string& hex) {
  std::string bytes;
  for (std::size_t i = 0; i < hex.size(); i += 2) bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  return bytes;
}

class JudgePictureTest : public testing::Test {
 protected:
  JudgePictureTest() {
    std::string name = (fs::temp_directory_path() / "plumb-judge-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder for the test");
    folder_ = fs::canonical(name);
    reference_ = read_reference(png("reference.png", {10, 20, 30, 40, 50, 60}));
  }
  ~JudgePictureTest() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  fs::path png(const std::string& name, const std::vector<std::uint8_t>& levels, int width = 2) const {
    write_png(levels, width, static_cast<int>(levels.size()) / 3 / width, folder_ / name);
    return folder_ / name;
  }
  fs::path exr(const std::string& name, double red) const {
    Image image(2, 1);
    image.at(1, 0).r = red;
    write_image(image, folder_ / name);
    return folder_ / name;
  }
  fs::path file(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }
  std::string bytes_of(const fs::path& path) const {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  CheckResult judge(const fs::path& picture, double tolerance = 0) const {
    return judge_picture(picture, reference_, tolerance).result;
  }

  fs::path folder_;
  Picture reference_;
};

TEST_F(JudgePictureTest, ADifferenceOfTheToleranceIsStillRight) {
  const fs::path two_off = png("x.png", {10, 20, 30, 40, 52, 60});
  for (const double tolerance : {0.0, 1.0, 1.999, 2.0, 3.0}) {
    const PictureJudgement judged = judge_picture(two_off, reference_, tolerance);
    EXPECT_EQ(judged.result.verdict, tolerance >= 2 ? Verdict::pass : Verdict::fail) << tolerance;
    EXPECT_EQ(judged.result.cause, tolerance >= 2 ? "" : "different");
    EXPECT_EQ(judged.result.margin, tolerance - 2);
    ASSERT_TRUE(judged.difference);
    EXPECT_EQ(judged.difference->max, 2);
    EXPECT_TRUE(judged.picture);
  }
}

TEST_F(JudgePictureTest, LinearPicturesAreComparedInLinearValues) {
  reference_ = read_reference(exr("zero.exr", 0));
  const fs::path picture = exr("x.exr", 0.25);
  EXPECT_EQ(judge(picture, 0.25).verdict, Verdict::pass);
  EXPECT_EQ(judge(picture, 0.2499).verdict, Verdict::fail);
  EXPECT_EQ(judge(picture, 0.25).margin, 0.0);
  EXPECT_THAT(judge(picture, 0.125).summary, HasSubstr("1 of 2 pixels differ by more than 0.125, the most by 0.25"));
}

TEST_F(JudgePictureTest, SamplesThatAreNoNumbersFail) {
  reference_ = read_reference(exr("zero.exr", 0));
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity(), 1e39}) {
    const PictureJudgement judged = judge_picture(exr("x.exr", value), reference_, 1e30);
    EXPECT_EQ(judged.result.verdict, Verdict::fail) << value;
    EXPECT_EQ(judged.result.cause, "not_finite") << value;
    EXPECT_EQ(judged.result.summary, "pixel (1,0) is not a finite number");
    EXPECT_EQ(judged.result.margin, std::nullopt);
    EXPECT_FALSE(judged.difference);
  }
}

TEST_F(JudgePictureTest, WhatIsNoPictureOfItsNameIsBad) {
  const std::string whole = bytes_of(png("whole.png", {10, 20, 30, 40, 50, 60}));
  const std::string whole_exr = bytes_of(exr("whole.exr", 0));
  const struct {
    const char* name;
    std::string bytes;
  } table[] = {
      {"empty.png", ""},
      {"text.png", "no picture at all"},
      {"tiff.png", std::string("II*\0\x08\0\0\0\0\0", 10)},
      {"exr.png", whole_exr},
      {"ppm.png", "P3 2 1 255 10 20 30 40 50 60"},
      {"png.ppm", whole},
      {"bad_number.ppm", "P3 2 x"},
      {"pgm.ppm", "P5 2 1 255 ab"},
  };
  for (const auto& row : table) {
    const CheckResult result = judge(file(row.name, row.bytes), 255);
    EXPECT_EQ(result.verdict, Verdict::fail) << row.name;
    EXPECT_EQ(result.cause, "bad_picture") << row.name;
    EXPECT_THAT(result.summary, Not(HasSubstr(folder_.string()))) << row.name;
  }
}

TEST_F(JudgePictureTest, APictureCutAnywhereIsBadAndSaysNoPath) {
  const std::string whole = bytes_of(png("whole.png", {10, 20, 30, 40, 50, 60}));
  std::size_t bad = 0;
  for (std::size_t size = 0; size + 12 < whole.size(); ++size) {  // the last 12 bytes, IEND, hold no pixel
    const CheckResult result = judge(file("cut.png", whole.substr(0, size)), 0);
    EXPECT_EQ(result.verdict, Verdict::fail) << size << " bytes";
    EXPECT_THAT(result.summary, Not(HasSubstr(folder_.string()))) << size << " bytes";
    bad += result.cause == "bad_picture" ? 1U : 0U;
  }
  EXPECT_EQ(bad, whole.size() - 12);
}

TEST_F(JudgePictureTest, CutPicturesOfOtherFormatsAreBad) {
  const std::string ppm = "P6 2 1 255\n" + std::string("\x0a\x14\x1e\x28\x32\x3c", 6);
  EXPECT_EQ(judge(file("whole.ppm", ppm)).verdict, Verdict::pass);
  for (std::size_t size = 0; size < ppm.size(); ++size) {
    const CheckResult result = judge(file("cut.ppm", ppm.substr(0, size)), 0);
    EXPECT_EQ(result.cause, "bad_picture") << size << " bytes: " << result.summary;
    EXPECT_THAT(result.summary, Not(HasSubstr(folder_.string()))) << size << " bytes";
  }
  reference_ = read_reference(exr("zero.exr", 0));
  const std::string whole = bytes_of(exr("whole.exr", 0));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const CheckResult result = judge(file("cut.exr", whole.substr(0, size)), 0);
    EXPECT_EQ(result.cause, "bad_picture") << size << " bytes: " << result.summary;
    EXPECT_THAT(result.summary, Not(HasSubstr(folder_.string()))) << size << " bytes";
  }
}

TEST_F(JudgePictureTest, DamagedDataIsBad) {
  std::string damaged = bytes_of(png("whole.png", {10, 20, 30, 40, 50, 60}));
  const std::size_t data = damaged.find("IDAT");
  ASSERT_NE(data, std::string::npos);
  damaged[data + 8] = static_cast<char>(damaged[data + 8] ^ 0x55);
  EXPECT_EQ(judge(file("damaged.png", damaged), 255).cause, "bad_picture") << "its checksum is wrong";
}

TEST_F(JudgePictureTest, TheSizeIsCheckedBeforeAnythingIsDecoded) {
  struct rusage before {};
  ASSERT_EQ(::getrusage(RUSAGE_SELF, &before), 0);
  // Headers with next to nothing after them.
  const CheckResult result =
      judge(file("large.png", from_hex("89504e470d0a1a0a0000000d4948445200003e8000003e800802000000ce1c4889"
                                       "000000094944415478da63000000010001b10db6930000000049454e44ae426082")));
  EXPECT_EQ(result.cause, "wrong_size");
  EXPECT_EQ(result.summary, "the picture is 16000x16000, expected 2x1");
  EXPECT_EQ(judge(file("large.ppm", "P6 16000 16000 255\n")).cause, "wrong_size");
  EXPECT_EQ(judge(file("huge.ppm", "P6 60000 60000 255\n")).cause, "bad_picture");
  EXPECT_EQ(judge(file("absurd.ppm", "P6 65536 1 255\n")).cause, "bad_picture");
  EXPECT_EQ(judge(file("none.ppm", "P6 0 0 255\n")).cause, "bad_picture");
  EXPECT_EQ(judge(png("turned.png", {10, 20, 30, 40, 50, 60}, 1)).cause, "wrong_size");
  struct rusage after {};
  ASSERT_EQ(::getrusage(RUSAGE_SELF, &after), 0);
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 500'000) << "KiB; decoded it would be 3 GB";
}

TEST_F(JudgePictureTest, ATransparentPictureIsAWarning) {
  const char* const kTransparent =  // the reference's colours, the second pixel with alpha 128
      "89504e470d0a1a0a0000000d4948445200000002000000010806000000f4227f8a000000114944415478da63e01291fbaf6164d3000008c2"
      "02527b24f9a00000000049454e44ae426082";
  const CheckResult result = judge(file("x.png", from_hex(kTransparent)));
  EXPECT_EQ(result.verdict, Verdict::quality_warning);
  EXPECT_EQ(result.cause, "transparent");
  EXPECT_EQ(result.margin, 0.0) << "colours are compared without alpha";
}

TEST_F(JudgePictureTest, SixteenBitsAreFractionsOfALevel) {
  const char* const kSixteenBits =  // the reference's colours times 257, the last channel 100 more
      "89504e470d0a1a0a0000000d49484452000000020000000110020000002bd0349e000000154944415478da63e0e212119193d3d03032b259"
      "0000085f020987cd5c200000000049454e44ae426082";
  const PictureJudgement judged = judge_picture(file("x.png", from_hex(kSixteenBits)), reference_, 0.5);
  EXPECT_EQ(judged.result.verdict, Verdict::pass);
  ASSERT_TRUE(judged.difference);
  EXPECT_NEAR(judged.difference->max, 100.0 / 257, 1e-5) << "samples are floats of 24 bits: 60 has an error below 4e-6";
}

TEST_F(JudgePictureTest, PlainAndBinaryPpmAreLevelsToo) {
  EXPECT_EQ(judge(file("plain.ppm", "P3\n# a comment\n2 1\n255\n10 20 30\n40 50 60\n")).verdict, Verdict::pass);
  EXPECT_EQ(judge(file("wrong.ppm", "P3 2 1 255 10 20 30 40 50 61")).margin, -1.0);
}

TEST_F(JudgePictureTest, LinearAndLevelsAreNotCompared) {
  EXPECT_EQ(judge(exr("x.exr", 0)).cause, "bad_picture");
  const fs::path levels = png("x.png", {10, 20, 30, 40, 50, 60});
  reference_ = read_reference(exr("zero.exr", 0));
  EXPECT_EQ(judge(levels).cause, "bad_picture");
  EXPECT_THAT(judge(levels).summary, HasSubstr("PNG cannot be compared with a reference in EXR"));
}

TEST_F(JudgePictureTest, AMissingPictureIsNoVerdict) { EXPECT_THROW(judge(folder_ / "gone.png"), InputError); }

TEST_F(JudgePictureTest, AReferenceMustBeWhole) {
  EXPECT_THROW(read_reference(folder_ / "gone.png"), InputError);
  EXPECT_THROW(read_reference(file("text.png", "text")), InputError);
  EXPECT_THROW(read_reference(exr("nan.exr", std::nan(""))), InputError);
}

}  // namespace
}  // namespace plumb

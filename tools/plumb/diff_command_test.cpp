// `plumb diff`, run as a program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "renderer/image/read_picture.h"
#include "renderer/image/write_image.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

std::string content(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class DiffCommandTest : public testing::Test {
 protected:
  DiffCommandTest() {
    std::string name = (fs::temp_directory_path() / "plumb-diff-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder for the test");
    folder_ = fs::canonical(name);
    png("a.png", {10, 20, 30, 40, 50, 60}, 2);
    png("b.png", {10, 20, 30, 40, 53, 60}, 2);
    png("narrow.png", {10, 20, 30}, 1);
    write("text.png", "no picture");
    write("cut.png", content(folder_ / "a.png").substr(0, 50));
    write("a.ppm", "P3 2 1 255 10 20 30 40 50 60");
    Image image(2, 1);
    write_image(image, folder_ / "a.exr");
    image.at(1, 0).r = 0.25;
    write_image(image, folder_ / "b.exr");
    image.at(0, 0).g = std::numeric_limits<double>::infinity();
    write_image(image, folder_ / "infinite.exr");
  }
  ~DiffCommandTest() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  void png(const std::string& name, const std::vector<std::uint8_t>& levels, int width) const {
    write_png(levels, width, 1, folder_ / name);
  }

  int diff(const std::string& arguments) {
    const std::string command =
        "cd '" + folder_.string() + "' && '" PLUMB_PROGRAM "' diff " + arguments + " >said.txt 2>complained.txt";
    const int status = std::system(command.c_str());
    said_ = content(folder_ / "said.txt");
    complained_ = content(folder_ / "complained.txt");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  fs::path folder_;
  std::string said_, complained_;
};

TEST_F(DiffCommandTest, TheExitStatusIsTheVerdict) {
  const struct {
    const char* arguments;
    int status;
    const char* said;
  } table[] = {
      {"a.png a.png", 0, "same: all 2 pixels equal"},
      {"a.ppm a.png", 0, "same: all 2 pixels equal"},
      {"a.png a.ppm", 0, "same: all 2 pixels equal"},
      {"a.exr a.exr", 0, "same: all 2 pixels equal"},
      {"b.png a.png", 1, "different: 1 of 2 pixels differ by more than 0 levels, the most by 3"},
      {"b.png a.png --tolerance 2", 1, "different"},
      {"b.png a.png --tolerance 3", 0, "same: largest difference 3, within 3 levels"},
      {"b.exr a.exr", 1, "the most by 0.25"},
      {"b.exr a.exr --tolerance 0.25", 0, "same"},
      {"b.exr a.exr --tolerance 0.249", 1, "different"},
      {"narrow.png a.png", 1, "the picture is 1x1, expected 2x1"},
      {"a.png narrow.png", 1, "the picture is 2x1, expected 1x1"},
      {"text.png a.png", 1, "different: the picture cannot be used"},
      {"a.png text.png", 1, "the reference cannot be used"},
      {"cut.png a.png", 1, "the picture cannot be used"},
      {"a.png cut.png", 1, "the reference cannot be used"},
      {"a.exr a.png", 1, "cannot be compared"},
      {"a.png a.exr", 1, "cannot be compared"},
      {"infinite.exr a.exr", 1, "pixel (0,0) is not a finite number"},
      {"a.exr infinite.exr", 1, "pixel (0,0) is not a finite number"},
  };
  for (const auto& row : table) {
    EXPECT_EQ(diff(row.arguments), row.status) << row.arguments << "\n" << said_ << complained_;
    EXPECT_THAT(said_, HasSubstr(row.said)) << row.arguments;
  }
}

TEST_F(DiffCommandTest, WhatCannotBeComparedIsAUsageError) {
  const struct {
    const char* arguments;
    const char* complaint;
  } table[] = {
      {"gone.png a.png", "gone.png: cannot open the picture: No such file"},
      {"a.png gone.png", "gone.png: cannot open the picture: No such file"},
      {". a.png", ": "},
      {"said.txt a.png", "unknown kind of picture '.txt'"},
      {"a.png", "reference"},
      {"", "picture"},
      {"a.png b.png extra", ""},
      {"a.png b.png --tolerance -1", "tolerance"},
      {"a.png b.png --tolerance x", "tolerance"},
      {"b.png a.png --tolerance nan", "tolerance"},
      {"a.png b.png --tolerence 1", ""},
      {"a.png b.png --out heat.txt", "expected a name that ends in .png"},
      {"b.exr a.exr --out heat.exr", "expected a name that ends in .png"},
      {"a.png b.png --out gone/heat.png", "does not exist"},
      {"a.png b.png --flip flip.jpg", "expected a name that ends in .png"},
      {"a.png b.png --flip gone/flip.png", "does not exist"},
      {"b.exr a.exr --flip flip.png", "a.exr: FLIP is defined for 8-bit levels"},
  };
  for (const auto& row : table) {
    EXPECT_EQ(diff(row.arguments), 2) << row.arguments << "\n" << said_;
    EXPECT_THAT(complained_ + said_, HasSubstr(row.complaint)) << row.arguments;
  }
  EXPECT_FALSE(fs::exists(folder_ / "heat.txt"));
}

TEST_F(DiffCommandTest, JsonHoldsEveryNumber) {
  EXPECT_EQ(diff("b.png a.png --json --tolerance 1"), 1);
  const nlohmann::json json = nlohmann::json::parse(said_);
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["verdict"], "fail");
  EXPECT_EQ(json["cause"], "different");
  EXPECT_EQ(json["tolerance"], 1);
  EXPECT_EQ(json["margin"], -2);
  EXPECT_EQ(json["pixels"], 2);
  EXPECT_EQ(json["pixels_past_tolerance"], 1);
  EXPECT_EQ(json["max"], 3);
  EXPECT_EQ(json["max_at"], nlohmann::json({1, 0}));
  EXPECT_EQ(json["channels"]["green"]["max"], 3);
  EXPECT_EQ(json["channels"]["green"]["mean"], 1.5);
  EXPECT_DOUBLE_EQ(json["channels"]["green"]["rms"], 2.1213203435596424);  // sqrt(9 / 2)
  EXPECT_EQ(json["channels"]["green"]["share_past_tolerance"], 0.5);
  EXPECT_EQ(json["channels"]["red"]["max"], 0);
}

TEST_F(DiffCommandTest, JsonSaysWhyAPictureCouldNotBeCompared) {
  for (const char* arguments :
       {"text.png a.png", "a.png text.png", "cut.png a.png", "narrow.png a.png", "infinite.exr a.exr"}) {
    EXPECT_EQ(diff(std::string(arguments) + " --json"), 1);
    const nlohmann::json json = nlohmann::json::parse(said_);
    EXPECT_EQ(json["verdict"], "fail") << arguments;
    EXPECT_FALSE(json["cause"].get<std::string>().empty()) << arguments;
    EXPECT_TRUE(json["margin"].is_null()) << arguments;
    EXPECT_FALSE(json.contains("channels")) << arguments;
  }
}

TEST_F(DiffCommandTest, TheHeatMapShowsWhere) {
  EXPECT_EQ(diff("b.png a.png --out heat.png"), 1);
  const Picture heat = read_picture(folder_ / "heat.png");
  ASSERT_EQ(heat.width, 2);
  ASSERT_EQ(heat.height, 1);
  EXPECT_EQ(heat.pixel(0, 0)[0], heat.pixel(0, 0)[2]) << "equal pixels have no colour";
  EXPECT_GT(heat.pixel(1, 0)[0], 100);
  EXPECT_EQ(diff("text.png a.png --out none.png"), 1);
  EXPECT_FALSE(fs::exists(folder_ / "none.png"));
}

TEST_F(DiffCommandTest, WhatIsSeenAndWhereIsAdded) {
  EXPECT_EQ(diff("b.png a.png"), 1);
  EXPECT_THAT(said_, HasSubstr("\n  FLIP: mean 0.0"));
  EXPECT_THAT(said_,
              HasSubstr("\n  wrong pixels: 1 blob, the largest of 1 within 1x1 at (1,0); most in 2x1 at (0,0): 1"));
  EXPECT_EQ(diff("b.png a.png --tolerance 3"), 0);
  EXPECT_THAT(said_, HasSubstr("FLIP: "));
  EXPECT_THAT(said_, Not(HasSubstr("wrong pixels")));
  for (const char* arguments : {"a.png a.png", "b.exr a.exr", "narrow.png a.png", "text.png a.png"}) {
    diff(arguments);
    EXPECT_THAT(said_, Not(HasSubstr("FLIP"))) << arguments;
    EXPECT_THAT(said_, Not(HasSubstr("explains"))) << arguments;
  }
  EXPECT_EQ(diff("b.png a.png --json"), 1);
  const nlohmann::json json = nlohmann::json::parse(said_);
  EXPECT_GT(json["flip"]["mean"], 0);
  EXPECT_GE(json["flip"]["max"], json["flip"]["p99"]);
  EXPECT_EQ(json["blobs"], 1);
  EXPECT_EQ(json["largest_blob"], nlohmann::json::parse(R"({"x":1,"y":0,"width":1,"height":1,"wrong":1})"));
  EXPECT_EQ(json["densest_window"]["wrong"], 1);
  EXPECT_FALSE(json.contains("faults"));
}

TEST_F(DiffCommandTest, ASimpleMistakeIsNamed) {
  const auto spot = [](int x, int y) { return static_cast<std::uint8_t>((x * x + 3 * y) % 251); };
  std::vector<std::uint8_t> straight, mirrored, transposed;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 16; ++x) {
      straight.insert(straight.end(), 3, spot(x, y));
      mirrored.insert(mirrored.end(), 3, spot(15 - x, y));
    }
  }
  for (int x = 0; x < 16; ++x)
    for (int y = 0; y < 8; ++y) transposed.insert(transposed.end(), 3, spot(x, y));
  write_png(straight, 16, 8, folder_ / "straight.png");
  write_png(mirrored, 16, 8, folder_ / "mirrored.png");
  write_png(transposed, 8, 16, folder_ / "transposed.png");
  EXPECT_EQ(diff("mirrored.png straight.png"), 1);
  EXPECT_THAT(said_,
              HasSubstr("\n  flip-left-right: the picture is mirrored: left and right are exchanged (explains 100 %)"));
  EXPECT_EQ(diff("mirrored.png straight.png --json"), 1);
  EXPECT_EQ(nlohmann::json::parse(said_)["faults"][0]["name"], "flip-left-right");
  EXPECT_EQ(diff("transposed.png straight.png"), 1);
  EXPECT_THAT(said_, StartsWith("different: the picture is 8x16, expected 16x8"));
  EXPECT_THAT(said_, HasSubstr("\n  transposition: "));
  write("cut-transposed.png", content(folder_ / "transposed.png").substr(0, 80));
  EXPECT_EQ(diff("cut-transposed.png straight.png"), 1);
  EXPECT_THAT(said_, Not(HasSubstr("transposition")));
}

TEST_F(DiffCommandTest, TheMapOfFlipIsBlackWhereNothingIsSeen) {
  EXPECT_EQ(diff("b.png a.png --flip flip.png"), 1);
  EXPECT_GT(read_picture(folder_ / "flip.png").pixel(1, 0)[0], 0);
  EXPECT_EQ(diff("a.png a.png --flip same.png"), 0);
  EXPECT_THAT(read_picture(folder_ / "same.png").samples, testing::Each(0.0F));
  EXPECT_EQ(diff("text.png a.png --flip none.png"), 1);
  EXPECT_FALSE(fs::exists(folder_ / "none.png"));
}

TEST_F(DiffCommandTest, AFileWhoseNameLooksLikeAnOptionCanBeGiven) {
  png("-rf.png", {10, 20, 30, 40, 50, 60}, 2);
  EXPECT_EQ(diff("-- -rf.png a.png"), 0) << complained_;
  EXPECT_EQ(diff("./-rf.png a.png"), 0) << complained_;
}

TEST_F(DiffCommandTest, HelpIsNoError) {
  EXPECT_EQ(diff("--help"), 0);
  EXPECT_THAT(said_, HasSubstr("--tolerance"));
}

#ifdef PLUMB_COURSE_SUITE
TEST_F(DiffCommandTest, RealStudentsWrongPicturesAreDifferent) {
  for (const char* name : {"bunny500_norms", "glazed-ball", "solids", "sphereSquished"}) {
    const std::string start = std::string("'" PLUMB_SHARED_DIR "/flip/") + name;
    EXPECT_EQ(diff(start + ".test.png' " + start + ".reference.png'"), 1) << name << complained_;
    EXPECT_THAT(said_, StartsWith("different: ")) << name;
    EXPECT_EQ(diff(start + ".test.png' " + start + ".reference.png' --tolerance 1"), 1) << name;
    EXPECT_EQ(diff(start + ".reference.png' " + start + ".reference.png'"), 0) << name;
  }
}
#endif

}  // namespace
}  // namespace plumb

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "conformance/judge/grade.h"
#include "renderer/image/write_image.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// The reference of every case here: two pixels.
constexpr std::array<std::uint8_t, 6> kLevels{10, 20, 30, 40, 50, 60};

/// A PNG of 2x1 pixels, RGBA: the colours of kLevels, the second pixel with alpha 128.
constexpr const char* kTransparent =
    "89504e470d0a1a0a0000000d4948445200000002000000010806000000f4227f8a000000114944415478da63e01291fbaf6164d3000008c202"
    "527b24f9a00000000049454e44ae426082";
/// The same colours but for a last channel that is 100/257 of a level brighter, 16 bits a channel.
constexpr const char* kSixteenBits =
    "89504e470d0a1a0a0000000d49484452000000020000000110020000002bd0349e000000154944415478da63e0e212119193d3d03032b25900"
    "00085f020987cd5c200000000049454e44ae426082";
/// A PNG whose header says 16000x16000, with nothing in it.
constexpr const char* kLarge =
    "89504e470d0a1a0a0000000d4948445200003e8000003e800802000000ce1c4889000000094944415478da63000000010001b10db693000000"
    "0049454e44ae426082";
/// The same with 60000x60000.
constexpr const char* kHuge =
    "89504e470d0a1a0a0000000d494844520000ea600000ea6008020000000fb0e215000000094944415478da63000000010001b10db693000000"
    "0049454e44ae426082";

std::string from_hex(const std::string& hex) {
  std::string bytes;
  for (std::size_t i = 0; i < hex.size(); i += 2) bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  return bytes;
}

/// A submission, `sub`, whose render.sh is run with scene and output, beside ready answers for it to hand over.
class GradeVerdictTest : public testing::Test {
 protected:
  GradeVerdictTest() {
    std::string name = (fs::temp_directory_path() / "plumb-grade-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder for the test");
    folder_ = fs::canonical(name);
    fs::create_directory(folder_ / "sub");
    write("scene.txt", "a scene");
    write_png(kLevels, 2, 1, folder_ / "ref.png");
    fs::copy_file(folder_ / "ref.png", folder_ / "sub/answer");
    write_answer("one_off", {10, 20, 30, 40, 51, 60}, 2);
    write_answer("two_off", {10, 20, 30, 40, 50, 58}, 2);
    write_answer("narrow", {10, 20, 30}, 1);
    write("sub/transparent", from_hex(kTransparent));
    write("sub/sixteen_bits", from_hex(kSixteenBits));
    write("sub/large", from_hex(kLarge));
    write("sub/huge", from_hex(kHuge));
  }
  ~GradeVerdictTest() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  void write_answer(const std::string& name, const std::vector<std::uint8_t>& levels, int width) const {
    write_png(levels, width, 1, folder_ / "sub/answer.png");
    fs::rename(folder_ / "sub/answer.png", folder_ / "sub" / name);
  }

  /// Grades by a suite of one case, with these keys more in its tables.
  CaseResult grade_case(const std::string& script, const std::string& case_keys = "",
                        const std::string& runner_keys = "", const std::string& suite_keys = "") const {
    write("sub/render.sh", script);
    const std::string render = runner_keys.find("render =") == std::string::npos
                                   ? "render = [\"/bin/sh\", \"render.sh\", \"{scene}\", \"{output}\"]\n"
                                   : "";
    write("suite.toml", "[suite]\nid = \"s\"\nschema = 1\n" + suite_keys + "\n[runner]\n" + render + runner_keys +
                            "\n[[case]]\nid = \"a\"\nscene = \"scene.txt\"\npoints = 5\n" +
                            (case_keys.find("reference") == std::string::npos ? "reference = \"ref.png\"\n" : "") +
                            case_keys + "\n");
    GradeRequest request;
    request.submission = folder_ / "sub";
    request.suite = read_suite(folder_ / "suite.toml");
    request.out = folder_ / "out";
    ResultSet results = grade(request);
    EXPECT_EQ(results.cases.size(), 1U);
    return results.cases.at(0);
  }

  fs::path folder_;
};

struct Provoked {
  const char* name;
  const char* script;
  const char* case_keys;
  Verdict verdict;
  const char* cause;
  const char* summary;
};

void PrintTo(const Provoked& provoked, std::ostream* out) { *out << provoked.name; }

class ProvokedVerdictTest : public GradeVerdictTest, public testing::WithParamInterface<Provoked> {};

TEST_P(ProvokedVerdictTest, IsJudgedWithItsCause) {
  const Provoked& provoked = GetParam();
  const CaseResult result = grade_case(provoked.script, provoked.case_keys);
  EXPECT_EQ(to_string(result.check.verdict), to_string(provoked.verdict)) << result.check.summary;
  EXPECT_EQ(result.check.cause, provoked.cause) << result.check.summary;
  EXPECT_THAT(result.check.summary, HasSubstr(provoked.summary));
  EXPECT_EQ(result.points, is_right(provoked.verdict) ? 5 : 0);
  EXPECT_EQ(result.max_points, 5);
  EXPECT_FALSE(result.pending);
  EXPECT_FALSE(result.excluded);
  EXPECT_EQ(result.check.advice.empty(), provoked.verdict == Verdict::pass) << result.check.advice;
  EXPECT_TRUE(fs::is_regular_file(folder_ / "out/results.json"));
  for (const char* file : {"case.json", "usage.json", "log.txt"})
    EXPECT_TRUE(fs::is_regular_file(folder_ / "out/cases/a" / file)) << file;
}

const Provoked kProvoked[] = {
    {"right", "cp answer \"$2\"", "", Verdict::pass, "", "all 2 pixels equal"},
    {"within_tolerance", "cp one_off \"$2\"", "tolerance = 1", Verdict::pass, "",
     "largest difference 1, within 1 level"},
    {"sixteen_bits", "cp sixteen_bits \"$2\"", "tolerance = 1", Verdict::pass, "", "within 1 level"},
    {"flood_of_50_megabytes", "head -c 50000000 /dev/zero | tr '\\0' x; cp answer \"$2\"", "", Verdict::pass, "", ""},
    {"files_with_strange_names", "touch -- -rf 'a b' \"it's\" 'a\nb' '\"' '$(x)'; cp answer \"$2\"", "", Verdict::pass,
     "", ""},
    {"child_left_behind", "sleep 100 & cp answer \"$2\"", "", Verdict::pass, "", ""},
    {"rewrites_its_scene", "echo changed > \"$1\"; cp answer \"$2\"", "", Verdict::pass, "", ""},
    {"exit_status", "cp answer \"$2\"; exit 3", "", Verdict::quality_warning, "exit_status", "all 2 pixels equal"},
    {"transparent", "cp transparent \"$2\"", "", Verdict::quality_warning, "transparent", "all 2 pixels equal"},
    {"no_picture_and_exit_0", "echo done", "", Verdict::fail, "no_picture", "there is no picture 'scene.txt.png'"},
    {"no_picture_and_exit_7", "exit 7", "", Verdict::fail, "no_picture", "the program ended with exit status 7"},
    {"picture_elsewhere", "cp answer elsewhere.png", "", Verdict::fail, "no_picture", "there is no picture"},
    {"empty", ": > \"$2\"", "", Verdict::fail, "bad_picture", "the picture cannot be used"},
    {"text", "echo hello > \"$2\"", "", Verdict::fail, "bad_picture", "wrong signature"},
    {"tiff", "printf 'II*\\000\\010\\000\\000\\000' > \"$2\"", "", Verdict::fail, "bad_picture", "wrong signature"},
    {"signature_alone", "head -c 8 answer > \"$2\"", "", Verdict::fail, "bad_picture", "cut short"},
    {"cut_short", "head -c 50 answer > \"$2\"", "", Verdict::fail, "bad_picture", "the picture cannot be used"},
    {"folder", "mkdir \"$2\"", "", Verdict::fail, "bad_picture", "is a folder"},
    {"pipe", "mkfifo \"$2\"", "", Verdict::fail, "bad_picture", "is a pipe"},
    {"narrow", "cp narrow \"$2\"", "", Verdict::fail, "wrong_size", "the picture is 1x1, expected 2x1"},
    {"large", "cp large \"$2\"", "", Verdict::fail, "wrong_size", "the picture is 16000x16000, expected 2x1"},
    {"huge", "cp huge \"$2\"", "", Verdict::fail, "bad_picture", "its size is 60000x60000"},
    {"different", "cp two_off \"$2\"", "tolerance = 1", Verdict::fail, "different",
     "1 of 2 pixels differ by more than 1 level, the most by 2"},
    {"past_tolerance_0", "cp one_off \"$2\"", "tolerance = 0", Verdict::fail, "different",
     "1 of 2 pixels differ by more than 0 levels, the most by 1"},
    {"sixteen_bits_past", "cp sixteen_bits \"$2\"", "tolerance = 0", Verdict::fail, "different", "the most by 0.389"},
    {"different_and_exit_1", "cp two_off \"$2\"; exit 1", "", Verdict::fail, "different", "1 of 2 pixels differ"},
    {"endless_loop", "while :; do :; done", "cpu_seconds = 1", Verdict::timeout, "cpu_time",
     "more than 1 s of processor time"},
    {"picture_then_endless_loop", "cp answer \"$2\"; while :; do :; done", "cpu_seconds = 1", Verdict::timeout,
     "cpu_time", ""},
    {"sleeps", "cp answer \"$2\"; sleep 100", "wall_seconds = 1", Verdict::timeout, "wall_time",
     "more than 1 s on the clock"},
    {"stops_itself", "kill -STOP $$", "wall_seconds = 1", Verdict::timeout, "wall_time", ""},
    {"memory",
     "x=0123456789abcdef; for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25; do x=$x$x; done; "
     "sleep 100",
     "memory_mb = 64", Verdict::memory_limit, "memory", "more than 64 MiB of memory"},
    {"output", "head -c 900000 /dev/zero > a; cp a b; cp a c; sleep 100", "output_mb = 1", Verdict::output_limit,
     "output_size", "more than 1 MiB"},
    {"output_of_one_file", "head -c 3000000 /dev/zero > a; cp answer \"$2\"; sleep 100", "output_mb = 1",
     Verdict::output_limit, "output_size", "more than 1 MiB"},
    {"output_and_ends", "head -c 900000 /dev/zero > a; cp a b; cp answer \"$2\"", "output_mb = 1",
     Verdict::output_limit, "output_size", "more than 1 MiB"},
    {"segmentation_fault", "cp answer \"$2\"; kill -SEGV $$", "", Verdict::crash, "signal", "ended by signal 11"},
    {"killed", "kill -KILL $$", "", Verdict::crash, "signal", "ended by signal 9"},
    {"link", "ln -s answer \"$2\"", "", Verdict::security, "link", "symbolic link"},
    {"dangling_link", "ln -s /nowhere/at/all \"$2\"", "", Verdict::security, "link", "symbolic link"},
    {"hard_link_to_the_input", "ln \"$1\" \"$2\"", "", Verdict::security, "link", "hard link"},
    {"build_changed", "f=$(readlink -f answer); chmod u+w \"$f\"; echo more >> \"$f\"; cp one_off \"$2\"", "",
     Verdict::security, "build_changed", "changed its own build"},
    {"build_grows", "d=$(dirname \"$(readlink -f answer)\"); chmod u+w \"$d\"; echo x > \"$d/cache\"; cp answer \"$2\"",
     "", Verdict::security, "build_changed", "changed its own build"},
    {"build_removed", "d=$(dirname \"$(readlink -f answer)\"); cp answer \"$2\"; chmod -R u+w \"$d\"; rm -rf \"$d\"",
     "", Verdict::security, "build_changed", "changed its own build"},
};

INSTANTIATE_TEST_SUITE_P(Grade, ProvokedVerdictTest, testing::ValuesIn(kProvoked),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST_F(GradeVerdictTest, TheMarginIsTheDistanceToTheTolerance) {
  EXPECT_EQ(grade_case("cp one_off \"$2\"", "tolerance = 1").check.margin, 0.0);
  EXPECT_EQ(grade_case("cp answer \"$2\"", "tolerance = 1").check.margin, 1.0);
  EXPECT_EQ(grade_case("cp two_off \"$2\"", "tolerance = 0.5").check.margin, -1.5);
  EXPECT_EQ(grade_case("true").check.margin, std::nullopt);
}

TEST_F(GradeVerdictTest, AMeasuredMarginStandsWithTheMeasurements) {
  const CaseResult result = grade_case("while :; do :; done", "cpu_seconds = 1");
  EXPECT_EQ(result.check.margin, std::nullopt);
  ASSERT_TRUE(result.measured_margin);
  EXPECT_LT(*result.measured_margin, 0);
}

TEST_F(GradeVerdictTest, ANonFinitePictureFails) {
  Image black(2, 1);
  write_image(black, folder_ / "ref.exr");
  Image broken = black;
  broken.at(1, 0).g = std::numeric_limits<double>::quiet_NaN();
  write_image(broken, folder_ / "nan.exr");
  fs::rename(folder_ / "nan.exr", folder_ / "sub/nan");
  const CaseResult result = grade_case("cp nan \"$2\"", "reference = \"ref.exr\"", "output = \"out.exr\"");
  EXPECT_EQ(result.check.verdict, Verdict::fail);
  EXPECT_EQ(result.check.cause, "not_finite");
  EXPECT_THAT(result.check.summary, HasSubstr("pixel (1,0)"));
}

TEST_F(GradeVerdictTest, EvidenceOfADifferenceLiesBesideTheResult) {
  const CaseResult result = grade_case("cp two_off \"$2\"");
  EXPECT_THAT(result.check.advice, HasSubstr("pixel (1,0): expected 40 50 60, found 40 50 58"));
  for (const char* file : {"picture.png", "reference.png", "difference.png"})
    EXPECT_TRUE(fs::is_regular_file(folder_ / "out/cases/a" / file)) << file;
  grade_case("cp answer \"$2\"");
  EXPECT_FALSE(fs::exists(folder_ / "out/cases/a/difference.png")) << "equal pictures, and an earlier result is gone";
}

TEST_F(GradeVerdictTest, APictureThatWasHandedInIsNotTheAnswer) {
  fs::copy_file(folder_ / "ref.png", folder_ / "sub/scene.txt.png");
  EXPECT_EQ(grade_case("true").check.cause, "no_picture");
  fs::create_directories(folder_ / "sub/data/scenes");
  fs::copy_file(folder_ / "ref.png", folder_ / "sub/data/scenes/scene.txt.png");
  EXPECT_EQ(grade_case("true", "", "scene_at = \"data/scenes/\"").check.cause, "no_picture");
  fs::create_directories(folder_ / "sub/out");
  fs::copy_file(folder_ / "ref.png", folder_ / "sub/out/answer.png");
  EXPECT_EQ(grade_case("true", "", "output = \"out/answer.png\"").check.cause, "no_picture");
}

TEST_F(GradeVerdictTest, AnInputThatHasTheNameOfThePictureIsNotTheAnswer) {
  fs::create_directory(folder_ / "inputs");
  fs::copy_file(folder_ / "ref.png", folder_ / "inputs/scene.txt.png");
  EXPECT_EQ(grade_case("true", "inputs = [\"inputs/scene.txt.png\"]").check.cause, "no_picture");
}

TEST_F(GradeVerdictTest, APlainTextPictureIsComparedWithAPngReference) {
  EXPECT_EQ(grade_case("printf 'P3 2 1 255 10 20 30 40 50 60' > \"$2\"", "tolerance = 0", "output = \"out.ppm\"")
                .check.verdict,
            Verdict::pass);
  EXPECT_EQ(
      grade_case("printf 'P3 2 1 255 10 20 30 40 50 62' > \"$2\"", "tolerance = 0", "output = \"out.ppm\"").check.cause,
      "different");
}

TEST_F(GradeVerdictTest, TheSceneLiesWhereTheRunnerSays) {
  const CaseResult result = grade_case(
      "[ \"$1\" = data/scenes/scene.txt ] && [ \"$(cat data/scenes/scene.txt)\" = 'a scene' ] && cp answer \"$2\"", "",
      "scene_at = \"data/scenes/\"");
  EXPECT_EQ(result.check.verdict, Verdict::pass) << result.check.summary;
}

}  // namespace
}  // namespace plumb

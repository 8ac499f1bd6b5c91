#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>

#include "conformance/judge/suite.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

/// The smallest suite; the line numbers of the errors below are those of this text.
constexpr const char* kSuite =
    "[suite]\n"                               // 1
    "id = \"small\"\n"                        // 2
    "schema = 1\n"                            // 3
    "[runner]\n"                              // 4
    "render = [\"./tracer\", \"{scene}\"]\n"  // 5
    "[[case]]\n"                              // 6
    "id = \"a\"\n"                            // 7
    "scene = \"scene.txt\"\n"                 // 8
    "reference = \"ref.png\"\n";              // 9

class SuiteFolder : public testing::Test {
 protected:
  SuiteFolder() {
    std::string name = (fs::temp_directory_path() / "plumb-suite-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder for the test");
    folder_ = fs::canonical(name);
    for (const char* file : {"scene.txt", "ref.png", "other.png", "mesh.msh", "more/mesh.msh", "staff/Main.java"})
      write(file, file);
  }
  ~SuiteFolder() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  Suite read(const std::string& text) const {
    write("suite.toml", text);
    return read_suite(folder_ / "suite.toml");
  }
  /// kSuite with the one place where `what` stands changed to `by`.
  static std::string changed(const std::string& what, const std::string& by) {
    std::string text = kSuite;
    const std::size_t at = text.find(what);
    if (at == std::string::npos || text.find(what, at + 1) != std::string::npos)
      throw std::logic_error("'" + what + "' is not there once");
    return text.replace(at, what.size(), by);
  }

  fs::path folder_;
};

struct BadSuite {
  const char* name;
  const char* what;
  const char* by;
  int line, column;
  const char* message;
};

void PrintTo(const BadSuite& bad, std::ostream* out) { *out << bad.name; }

class BadSuiteTest : public SuiteFolder, public testing::WithParamInterface<BadSuite> {};

TEST_P(BadSuiteTest, IsRefusedAtItsPlace) {
  const BadSuite& bad = GetParam();
  try {
    read(changed(bad.what, bad.by));
    FAIL() << "was read:\n" << changed(bad.what, bad.by);
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(bad.message));
    EXPECT_EQ(error.where().file, (folder_ / "suite.toml").string());
    EXPECT_EQ(error.where().line, bad.line) << error.what();
    EXPECT_EQ(error.where().column, bad.column) << error.what();
  }
}

const std::string kUnknownPrerequisite =
    std::string("reference = \"ref.png\"\nrequires = [\"alpha\"]\n[[case]]\nid = \"alpha1\"\nscene = \"scene.txt\"\n") +
    "reference = \"ref.png\"\n";
const std::string kCycle = std::string(
                               "reference = \"ref.png\"\nrequires = [\"b\"]\n[[case]]\nid = \"b\"\nrequires = "
                               "[\"a\"]\nscene = \"scene.txt\"\n") +
                           "reference = \"ref.png\"\n";
const std::string kTwice =
    std::string("reference = \"ref.png\"\n[[case]]\nid = \"a\"\nscene = \"scene.txt\"\n") + "reference = \"ref.png\"\n";

const BadSuite kBadSuites[] = {
    {"malformed", "schema = 1", "schema = ", 3, 10, "malformed TOML"},
    {"key_twice", "schema = 1", "schema = 1\nschema = 1", 4, 10, "malformed TOML"},
    {"no_suite", "[suite]", "[siute]", 1, 1, "did you mean 'suite'?"},
    {"unknown_table", "[[case]]", "[runer]\n[[case]]", 6, 1,
     "unknown key 'runer', expected [suite], [[variant]], [runner] or [[case]]; did you mean 'runner'?"},
    {"unknown_suite_key", "schema = 1", "schema = 1\nskiped = \"zero\"", 4, 10,
     "unknown key 'skiped' in [suite], expected dialect, id"},
    {"unknown_suite_key_nearest", "schema = 1", "schema = 1\nskiped = \"zero\"", 4, 10, "did you mean 'skipped'?"},
    {"unknown_runner_key", "{scene}\"]", "{scene}\"]\nbiuld = []", 6, 9, "did you mean 'build'?"},
    {"unknown_case_key", "scene = \"scene.txt\"", "scene = \"scene.txt\"\ntolerence = 1", 9, 13,
     "unknown key 'tolerence' in [[case]]"},
    {"unknown_case_key_nearest", "scene = \"scene.txt\"", "scene = \"scene.txt\"\ntolerence = 1", 9, 13,
     "did you mean 'tolerance'?"},
    {"no_suite_id", "id = \"small\"\n", "", 1, 1, "'id' of [suite] is missing"},
    {"no_schema", "schema = 1\n", "", 1, 1, "'schema' of [suite] must be 1"},
    {"schema_2", "schema = 1", "schema = 2", 3, 10, "must be 1, the version of this format"},
    {"schema_text", "schema = 1", "schema = \"1\"", 3, 10, "'schema' of [suite] is not a whole number"},
    {"no_runner", "[runner]\nrender = [\"./tracer\", \"{scene}\"]\n", "", 1, 1, "own_runner = true"},
    {"no_render", "render = [\"./tracer\", \"{scene}\"]\n", "", 4, 1, "'render' of [runner] is missing or empty"},
    {"empty_render", "[\"./tracer\", \"{scene}\"]", "[]", 5, 10, "'render' of [runner] is missing or empty"},
    {"render_text", "[\"./tracer\", \"{scene}\"]", "\"./tracer {scene}\"", 5, 10, "is no list"},
    {"render_number", "\"./tracer\"", "7", 5, 11, "an item of 'render' is no text"},
    {"no_case_id", "id = \"a\"\n", "", 6, 1, "'id' of [[case]] is missing"},
    {"no_scene", "scene = \"scene.txt\"\n", "", 6, 1, "'scene' of [[case]] is missing"},
    {"envelopes_beside_reference", "reference = \"ref.png\"", "reference = \"ref.png\"\nenvelopes = [\".\"]", 9, 13,
     "stands beside 'envelopes'"},
    {"envelopes_missing", "reference = \"ref.png\"", "envelopes = [\"none\"]", 9, 13,
     "names a folder that does not exist"},
    {"envelopes_for_each_variant", "reference = \"ref.png\"", "envelopes = [\".\", \".\"]", 9, 13,
     "names 2 folders, expected one for each of the 1 variants"},
    {"envelopes_empty", "reference = \"ref.png\"", "envelopes = [\".\"]", 9, 13, "names a folder without nominal.png"},
    {"variant_twice", "[[case]]", "[[variant]]\nid = \"v\"\n[[variant]]\nid = \"v\"\n[[case]]", 9, 6,
     "is 'v', which an earlier variant has"},
    {"variant_samples", "[[case]]", "[[variant]]\nid = \"v\"\nsamples = \"sideways\"\n[[case]]", 8, 11,
     "expected nearest, up, down"},
    {"case_is_table", "[[case]]", "[case]", 6, 1, "expected at least one [[case]]"},
    {"no_case", "[[case]]\nid = \"a\"\nscene = \"scene.txt\"\nreference = \"ref.png\"\n", "", 1, 1,
     "'case' of the suite is missing"},
    {"id_number", "id = \"a\"", "id = 1", 7, 6, "'id' of [[case]] is no text"},
    {"id_empty", "id = \"a\"", "id = \"\"", 7, 6, "expected a name of letters"},
    {"id_climbs", "id = \"a\"", "id = \"../x\"", 7, 6, "is '../x', expected a name of letters"},
    {"id_option", "id = \"a\"", "id = \"-x\"", 7, 6, "is '-x', expected a name of letters"},
    {"id_hidden", "id = \"a\"", "id = \".x\"", 7, 6, "is '.x', expected a name of letters"},
    {"id_slash", "id = \"a\"", "id = \"x/y\"", 7, 6, "expected a name of letters"},
    {"id_space", "id = \"a\"", "id = \"x y\"", 7, 6, "expected a name of letters"},
    {"id_newline", "id = \"a\"", "id = \"x\\ny\"", 7, 6, "is 'x?y', expected a name of letters"},
    {"suite_id_climbs", "id = \"small\"", "id = \"../x\"", 2, 6, "'id' of [suite] is '../x'"},
    {"id_twice", "reference = \"ref.png\"\n", kTwice.c_str(), 11, 6, "is 'a', which an earlier case has"},
    {"requires_unknown", "reference = \"ref.png\"\n", kUnknownPrerequisite.c_str(), 6, 1,
     "case 'a' requires 'alpha', which is no case of this suite; did you mean 'alpha1'?"},
    {"requires_itself", "reference = \"ref.png\"", "reference = \"ref.png\"\nrequires = [\"a\"]", 6, 1,
     "case 'a' requires itself"},
    {"requires_cycle", "reference = \"ref.png\"\n", kCycle.c_str(), 6, 1,
     "case 'a' requires itself, directly or through others"},
    {"requires_text", "reference = \"ref.png\"", "reference = \"ref.png\"\nrequires = \"a\"", 10, 12, "is no list"},
    {"missing_scene", "scene = \"scene.txt\"", "scene = \"gone.txt\"", 8, 9,
     "'scene' of [[case]] names a file that does not exist"},
    {"scene_is_folder", "scene = \"scene.txt\"", "scene = \"more\"", 8, 9, "names a file that does not exist"},
    {"missing_reference", "\"ref.png\"", "\"gone.png\"", 9, 13,
     "'reference' of [[case]] names a file that does not exist"},
    {"missing_input", "scene = \"scene.txt\"", "scene = \"scene.txt\"\ninputs = [\"gone.msh\"]", 9, 10,
     "'inputs' of [[case]] names a file that does not exist"},
    {"missing_overlay", "[runner]", "[runner]\noverlay = \"gone/\"", 5, 11, "names a folder that does not exist"},
    {"overlay_is_file", "[runner]", "[runner]\noverlay = \"ref.png\"", 5, 11, "names a folder that does not exist"},
    {"inputs_of_one_name", "scene = \"scene.txt\"", "scene = \"scene.txt\"\ninputs = [\"mesh.msh\", \"more/mesh.msh\"]",
     9, 10, "holds two files named 'mesh.msh'"},
    {"render_placeholder", "{scene}", "{scenes}", 5, 10,
     "holds '{scenes}', which stands for nothing here; expected {scene}, {scene_name}, {folder}, {output}, {width}, "
     "{height}; did you "
     "mean 'scene'?"},
    {"render_sources", "{scene}", "{sources:*.c}", 5, 10, "which stands for nothing here"},
    {"build_placeholder", "[runner]", "[runner]\nbuild = [[\"cc\", \"{scene}\"]]", 5, 9,
     "holds '{scene}', which stands for nothing here"},
    {"sources_inside", "[runner]", "[runner]\nbuild = [[\"cc\", \"-I{sources:*.c}\"]]", 5, 9,
     "expected {sources:GLOB} as an argument of its own"},
    {"output_placeholder", "[runner]", "[runner]\noutput = \"{output}.png\"", 5, 10, "holds '{output}'"},
    {"build_no_shell", "[runner]", "[runner]\nbuild = [\"make all\"]", 5, 10, "there is no shell"},
    {"build_text", "[runner]", "[runner]\nbuild = \"make\"", 5, 9, "is no list of lists"},
    {"build_empty", "[runner]", "[runner]\nbuild = [[]]", 5, 9, "holds an empty command"},
    {"env_list", "[runner]", "[runner]\nenv = [\"A=1\"]", 5, 7, "is no table"},
    {"env_number", "[runner]", "[runner]\nenv = { A = 1 }", 5, 13, "'A' is no text"},
    {"output_absolute", "[runner]", "[runner]\noutput = \"/tmp/x.png\"", 5, 10, "expected a relative path"},
    {"output_empty", "[runner]", "[runner]\noutput = \"\"", 5, 10, "expected a relative path"},
    {"output_escapes", "[runner]", "[runner]\noutput = \"a/../../x.png\"", 5, 10, "expected a path that stays inside"},
    {"output_is_no_picture", "[runner]", "[runner]\noutput = \"{scene}.jpg\"", 5, 10,
     "expected a picture: .png, .exr or .ppm"},
    {"scene_at_absolute", "[runner]", "[runner]\nscene_at = \"/tmp\"", 5, 12, "expected a relative path"},
    {"scene_at_escapes", "[runner]", "[runner]\nscene_at = \"../x\"", 5, 12, "expected a path that stays inside"},
    {"root_marker_absolute", "[runner]", "[runner]\nroot_marker = \"/x\"", 5, 15, "expected a relative path"},
    {"root_marker_escapes", "[runner]", "[runner]\nroot_marker = \"../x\"", 5, 15, "expected a path that stays inside"},
    {"points_negative", "\"scene.txt\"", "\"scene.txt\"\npoints = -1", 9, 10,
     "'points' of [[case]] is not a number of at least 0"},
    {"points_text", "\"scene.txt\"", "\"scene.txt\"\npoints = \"1\"", 9, 10, "'points' of [[case]] is not a number"},
    {"points_infinite", "\"scene.txt\"", "\"scene.txt\"\npoints = inf", 9, 10, "'points' of [[case]] is not a number"},
    {"tolerance_negative", "\"scene.txt\"", "\"scene.txt\"\ntolerance = -0.5", 9, 13,
     "'tolerance' of [[case]] is not a number"},
    {"tolerance_nan", "\"scene.txt\"", "\"scene.txt\"\ntolerance = nan", 9, 13,
     "'tolerance' of [[case]] is not a number"},
    {"cpu_zero", "\"scene.txt\"", "\"scene.txt\"\ncpu_seconds = 0", 9, 15, "'cpu_seconds' of [[case]] is not a number"},
    {"wall_negative", "\"scene.txt\"", "\"scene.txt\"\nwall_seconds = -1", 9, 16,
     "'wall_seconds' of [[case]] is not a number"},
    {"memory_zero", "\"scene.txt\"", "\"scene.txt\"\nmemory_mb = 0", 9, 13,
     "'memory_mb' of [[case]] is not a whole number from 1 to 1073741824"},
    {"memory_absurd", "\"scene.txt\"", "\"scene.txt\"\nmemory_mb = 9223372036854775807", 9, 13,
     "'memory_mb' of [[case]]"},
    {"reference_as_input", "\"scene.txt\"", "\"scene.txt\"\ninputs = [\"ref.png\"]", 9, 10, "holds the reference"},
    {"memory_fraction", "\"scene.txt\"", "\"scene.txt\"\nmemory_mb = 1.5", 9, 13,
     "'memory_mb' of [[case]] is not a whole number"},
    {"output_mb_negative", "\"scene.txt\"", "\"scene.txt\"\noutput_mb = -1", 9, 13,
     "'output_mb' of [[case]] is not a whole number"},
    {"total_seconds_zero", "schema = 1", "schema = 1\ntotal_seconds = 0", 4, 17,
     "'total_seconds' of [suite] is not a number"},
    {"build_seconds_zero", "[runner]", "[runner]\nbuild_seconds = 0", 5, 17,
     "'build_seconds' of [runner] is not a number"},
    {"own_runner_text", "schema = 1", "schema = 1\nown_runner = \"true\"", 4, 14, "is neither true nor false"},
    {"visibility", "\"scene.txt\"", "\"scene.txt\"\nvisibility = \"hiden\"", 9, 14,
     "is 'hiden', expected visible, hidden, after_due_date, after_published; did you mean 'hidden'?"},
    {"kind", "\"scene.txt\"", "\"scene.txt\"\nkind = \"probe\"", 9, 8, "is 'probe', expected image"},
    {"skipped", "schema = 1", "schema = 1\nskipped = \"nought\"", 4, 11,
     "is 'nought', expected zero, excluded, manual"},
};

INSTANTIATE_TEST_SUITE_P(ReadSuite, BadSuiteTest, testing::ValuesIn(kBadSuites),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST_F(SuiteFolder, AMissingSuiteIsAnInputError) { EXPECT_THROW(read_suite(folder_ / "gone.toml"), InputError); }

TEST_F(SuiteFolder, AFolderIsNoSuite) { EXPECT_THROW(read_suite(folder_), InputError); }

TEST_F(SuiteFolder, DefaultsAreThoseOfTheFormat) {
  const Suite suite = read(kSuite);
  EXPECT_EQ(suite.id, "small");
  EXPECT_EQ(suite.total_seconds, 3600);
  EXPECT_FALSE(suite.own_runner);
  EXPECT_TRUE(suite.has_runner);
  EXPECT_EQ(suite.skipped, SkippedPolicy::zero);
  EXPECT_EQ(suite.build_seconds, 120);
  EXPECT_THAT(suite.root_marker, IsEmpty());
  EXPECT_TRUE(suite.overlay.empty());
  EXPECT_THAT(suite.runner.build, IsEmpty());
  EXPECT_THAT(suite.runner.render, ElementsAre("./tracer", "{scene}"));
  EXPECT_EQ(suite.runner.output, "{scene}.png");
  ASSERT_EQ(suite.cases.size(), 1U);
  const SuiteCase& c = suite.cases[0];
  EXPECT_EQ(c.kind, "image");
  EXPECT_EQ(c.scene, folder_ / "scene.txt");
  EXPECT_EQ(c.reference, folder_ / "ref.png");
  EXPECT_THAT(c.inputs, ElementsAre(folder_ / "scene.txt"));
  EXPECT_EQ(c.points, 1);
  EXPECT_EQ(c.tolerance, 1);
  EXPECT_EQ(c.cpu_seconds, 30);
  EXPECT_EQ(c.wall_seconds, 90);
  EXPECT_EQ(c.memory_mb, 2048);
  EXPECT_EQ(c.output_mb, 64);
  EXPECT_EQ(c.visibility, "visible");
  EXPECT_THAT(c.prerequisites, IsEmpty());
}

TEST_F(SuiteFolder, EveryValueIsTaken) {
  const Suite suite = read(
      "[suite]\nid = \"s\"\nschema = 1\ndialect = \"d\"\ntotal_seconds = 7\nown_runner = "
      "true\nskipped = \"manual\"\n"
      "[runner]\nbuild = [[\"cc\", \"{sources:*.c}\"], [\"true\"]]\nrender = [\"./t\", \"{folder}/{scene_name}\"]\nenv "
      "= { B = \"2\", A = \"1\" }\noutput = \"o.ppm\"\n"
      "scene_at = \"data/\"\nroot_marker = \"m\"\noverlay = \"staff/\"\nbuild_seconds = 9\n"
      "[[case]]\nid = \"a\"\nscene = \"scene.txt\"\ninputs = [\"mesh.msh\"]\nreference = \"ref.png\"\nrequirement = "
      "\"r\"\npoints = 2.5\nrequires = [\"b\"]\n"
      "tolerance = 0\ncpu_seconds = 2\nmemory_mb = 3\noutput_mb = 4\nvisibility = \"hidden\"\n"
      "[[case]]\nid = \"b\"\nscene = \"scene.txt\"\nreference = \"ref.png\"\nwall_seconds = 5\n"
      "[[variant]]\nid = \"x\"\nsamples = \"up\"\ncutoff = false\nfresnel = \"schlick\"\n[[variant]]\nid = \"y\"\n");
  EXPECT_EQ(suite.dialect, "d");
  EXPECT_THAT(suite.variants, ElementsAre(Variant{"x", SampleRounding::up, false, Fresnel::schlick},
                                          Variant{"y", SampleRounding::nearest, true, Fresnel::exact}));
  EXPECT_EQ(suite.total_seconds, 7);
  EXPECT_TRUE(suite.own_runner);
  EXPECT_EQ(suite.skipped, SkippedPolicy::manual);
  EXPECT_THAT(suite.runner.build, ElementsAre(ElementsAre("cc", "{sources:*.c}"), ElementsAre("true")));
  EXPECT_THAT(suite.runner.env, ElementsAre(Pair("A", "1"), Pair("B", "2")));
  EXPECT_EQ(suite.runner.scene_at, "data/");
  EXPECT_EQ(suite.build_seconds, 9);
  ASSERT_EQ(suite.cases.size(), 2U);
  EXPECT_THAT(suite.cases[0].prerequisites, ElementsAre(1U));
  EXPECT_THAT(suite.cases[0].inputs, ElementsAre(folder_ / "mesh.msh", folder_ / "scene.txt"));
  EXPECT_EQ(suite.cases[0].points, 2.5);
  EXPECT_EQ(suite.cases[0].wall_seconds, 6) << "three times the processor time";
  EXPECT_EQ(suite.cases[1].wall_seconds, 5);
}

TEST_F(SuiteFolder, WhereSubmissionsBringTheirCommandsTheSuiteNeedsNone) {
  const Suite suite = read(changed("schema = 1\n[runner]\nrender = [\"./tracer\", \"{scene}\"]",
                                   "schema = 1\nown_runner = true\n[runner]\nroot_marker = \"m\""));
  EXPECT_FALSE(suite.has_runner);
  EXPECT_EQ(suite.root_marker, "m");
}

TEST_F(SuiteFolder, TheHashFollowsTheContentOfEveryNamedFile) {
  const std::string text = changed("[runner]", "[runner]\noverlay = \"staff\"") + "inputs = [\"mesh.msh\"]\n";
  const std::string hash = read(text).hash;
  EXPECT_THAT(hash, testing::MatchesRegex("[0-9a-f]{64}"));
  for (const char* named : {"scene.txt", "ref.png", "mesh.msh", "staff/Main.java"}) {
    write(named, "changed");
    EXPECT_NE(read(text).hash, hash) << named;
    write(named, named);
    EXPECT_EQ(read(text).hash, hash) << named;
  }
  EXPECT_NE(read(text + "# a comment\n").hash, hash);
  write("staff/More.java", "");
  EXPECT_NE(read(text).hash, hash) << "a file more in the overlay";
  fs::remove(folder_ / "staff/More.java");
  for (const char* other : {"other.png", "more/mesh.msh"}) {
    write(other, "changed");
    EXPECT_EQ(read(text).hash, hash) << other;
  }
}

TEST_F(SuiteFolder, TheHashIsTheSameInAnotherPlace) {
  const std::string hash = read(kSuite).hash;
  const fs::path there = folder_ / "there";
  fs::create_directory(there);
  for (const char* file : {"suite.toml", "scene.txt", "ref.png"}) fs::copy_file(folder_ / file, there / file);
  EXPECT_EQ(read_suite(there / "suite.toml").hash, hash);
}

}  // namespace
}  // namespace plumb

#include "conformance/judge/build_suite.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>

#include "conformance/envelopes/envelope.h"
#include "conformance/judge/suite.h"
#include "renderer/image/write_image.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A suite of two small scenes, of matt and of glass.
class BuildSuiteTest : public testing::Test {
 protected:
  BuildSuiteTest() {
    std::string name = (fs::temp_directory_path() / "plumb-suite-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder for the test");
    folder_ = fs::canonical(name);
    write("matt.xml", scene("Lambertian"));
    write("glass.xml", scene("Glass"));
    write("suite.toml",
          "[suite]\nid = \"s\"\nschema = 1\ndialect = \"pa3-2011\"\n[runner]\nrender = [\"/bin/true\"]\n"
          "[[variant]]\nid = \"course\"\n[[variant]]\nid = \"free\"\ncutoff = false\n"
          "[[case]]\nid = \"matt\"\nscene = \"matt.xml\"\npoints = 6\n"
          "[[case]]\nid = \"glass\"\nscene = \"glass.xml\"\npoints = 3\nrequires = [\"matt\"]\n");
  }
  ~BuildSuiteTest() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  static std::string scene(const std::string& shader) {
    const std::string index = shader == "Glass" ? "<refractiveIndex>1.5</refractiveIndex>" : "";
    return "<scene><camera><viewPoint>1 2 5</viewPoint><viewDir>-1 -2 -5</viewDir></camera><image>40 30</image>"
           "<light><position>3 5 4</position></light><surface type='Sphere'><shader type='" +
           shader + "'>" + index +
           "</shader></surface><surface type='Box'><minPt>-4 -2 -4</minPt><maxPt>4 -1.2 4</maxPt></surface></scene>";
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  SuiteBuildRequest request(const std::string& out, int jitters = 0, std::uint64_t seed = 1) const {
    SuiteBuildRequest r;
    r.suite = folder_ / "suite.toml";
    r.out = folder_ / out;
    r.jitters = jitters;
    r.seed = seed;
    r.plumb_version = "0";
    return r;
  }
  std::string content(const fs::path& file) const {
    std::ifstream stream(folder_ / file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  fs::path folder_;
};

TEST_F(BuildSuiteTest, HoldsAllThatGradingNeeds) {
  const BuiltSuite built = build_suite(request("built"));
  ASSERT_EQ(built.cases.size(), 2u);
  EXPECT_LT(built.cases[0].undecidable_share, 0.02);
  fs::remove(folder_ / "matt.xml");  // it stands by itself, and may be moved
  fs::rename(folder_ / "built", folder_ / "moved");
  const Suite suite = read_suite(folder_ / "moved/suite.toml");
  EXPECT_FALSE(suite.needs_build());
  ASSERT_EQ(suite.cases.size(), 2u);
  EXPECT_EQ(suite.cases[0].envelopes[0], suite.cases[0].envelopes[1])
      << "the cutoff makes no difference to matt things";
  EXPECT_NE(suite.cases[1].envelopes[0], suite.cases[1].envelopes[1]);
  EXPECT_THAT(suite.cases[1].prerequisites, ElementsAre(0u));
  EXPECT_EQ(read_envelope(suite.cases[1].envelopes[1]).width, 40);
  EXPECT_THAT(verify_suite(folder_ / "moved"), IsEmpty());
}

TEST_F(BuildSuiteTest, TheSameSuiteAndSeedGiveTheSameBytes) {
  build_suite(request("one", 2, 7));
  build_suite(request("again", 2, 7));
  build_suite(request("other", 2, 8));
  EXPECT_EQ(content("one/manifest.json"), content("again/manifest.json"));
  EXPECT_NE(content("one/manifest.json"), content("other/manifest.json"));
  const Suite suite = read_suite(folder_ / "one/suite.toml");
  ASSERT_EQ(suite.cases.size(), 6u);
  EXPECT_EQ(suite.cases[1].id, "matt.view1");
  EXPECT_DOUBLE_EQ(suite.cases[1].points, 2);
  double points = 0;
  for (const SuiteCase& c : suite.cases) points += c.points;
  EXPECT_DOUBLE_EQ(points, 9);
  EXPECT_NE(read_envelope(suite.cases[0].envelopes[0]).nominal, read_envelope(suite.cases[1].envelopes[0]).nominal);
  EXPECT_THAT(content("one/manifest.json"), HasSubstr("\"seed\": 7"));
}

TEST_F(BuildSuiteTest, VerifySaysWhatIsMissingChangedAndAdded) {
  build_suite(request("built"));
  fs::remove(folder_ / "built/cases/matt/matt.xml");
  write("built/suite.toml", "changed");
  write("built/new", "new");
  EXPECT_THAT(verify_suite(folder_ / "built"),
              ElementsAre("cases/matt/matt.xml: is missing", "suite.toml: was changed", "new: was added"));
  EXPECT_THROW(verify_suite(folder_), InputError);
}

TEST_F(BuildSuiteTest, RefusesASceneThatCannotBeDecided) {
  write("suite.toml", content("suite.toml").replace(0, 7, "[suite]\nundecidable_limit = 0.0001\n"));
  try {
    build_suite(request("built"));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("case 'glass': a correct program may answer differently"));
  }
  EXPECT_FALSE(fs::exists(folder_ / "built"));
  EXPECT_FALSE(fs::exists(folder_ / "built.partial"));
}

TEST_F(BuildSuiteTest, NeverReplacesWhatIsNoSuite) {
  fs::create_directory(folder_ / "precious");
  write("precious/thesis.txt", "years of work");
  EXPECT_THROW(build_suite(request("precious")), InputError);
  EXPECT_EQ(content("precious/thesis.txt"), "years of work");
  build_suite(request("built"));
  build_suite(request("built"));
}

TEST_F(BuildSuiteTest, TakesKnownCorrectPicturesInPlaceOfScenes) {
  fs::create_directories(folder_ / "right/matt");
  fs::create_directories(folder_ / "right/glass");
  write_png(std::vector<std::uint8_t>(3 * 1200, 70), 40, 30, folder_ / "right/matt/a.png");
  write_png(std::vector<std::uint8_t>(3 * 1200, 71), 40, 30, folder_ / "right/matt/b.png");
  SuiteBuildRequest r = request("built");
  r.pictures = folder_ / "right";
  EXPECT_THROW(build_suite(r), InputError) << "none of glass";
  write_png(std::vector<std::uint8_t>(3 * 1200, 90), 40, 30, folder_ / "right/glass/a.png");
  write("matt.xml", "another format");
  write("glass.xml", "another format");
  const BuiltSuite built = build_suite(r);
  EXPECT_TRUE(built.cases[0].guessed);
  const Suite suite = read_suite(folder_ / "built/suite.toml");
  const Envelope e = read_envelope(suite.cases[0].envelopes[1]);
  EXPECT_TRUE(e.guessed);
  EXPECT_EQ(e.low[0], 70);
  EXPECT_EQ(e.high[0], 71);
}

TEST_F(BuildSuiteTest, GrowthCasesGoOnSharingTheirTemplateAndGate) {
  write("mesh.xml", "<scene>{mesh}</scene>");
  write("suite.toml", content("suite.toml") +
                          "[[case]]\nid = \"trace\"\nkind = \"growth\"\nmeasure = \"trace\"\nscene = \"mesh.xml\"\n"
                          "[[case]]\nid = \"build\"\nkind = \"growth\"\nmeasure = \"build\"\nscene = \"mesh.xml\"\n");
  build_suite(request("built"));
  const Suite suite = read_suite(folder_ / "built/suite.toml");
  ASSERT_EQ(suite.cases.size(), 4u);
  EXPECT_EQ(suite.cases[2].growth, suite.cases[3].growth);
}

}  // namespace
}  // namespace plumb

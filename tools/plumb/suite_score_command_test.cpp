// `plumb suite score`, run as a program, on a suite of two small scenes and pictures of one known mistake.
#include "tools/plumb/program_for_tests.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

/// The suite has the cases that the known mistake `lights-overwrite` names.
class SuiteScoreCommandTest : public ProgramTest {
 protected:
  SuiteScoreCommandTest() {
    write("right.xml", scene("0.4"));
    write("wrong.xml", scene("0.1"));
    write("suite.toml",
          "[suite]\nid = \"lights\"\nschema = 1\nown_runner = true\n[[case]]\nid = \"two-lights\"\nscene = "
          "\"right.xml\"\n"
          "[[case]]\nid = \"phong\"\nscene = \"right.xml\"\n");
    EXPECT_EQ(plumb("suite build suite.toml -o built --without-fingerprints"), 0) << complained_;
    EXPECT_EQ(plumb("render wrong.xml -o wrong.png"), 0) << complained_;
    EXPECT_EQ(shell("sed -i 's/^\\[suite\\]/[suite]\\nfingerprints = \"fingerprints\"/' built/suite.toml"), 0);
  }

  /// A ball and a light of this intensity.
  static std::string scene(const std::string& intensity) {
    return "<scene><camera><viewPoint>0.2 0.4 7</viewPoint><viewDir>0 0 -1</viewDir><viewWidth>0.5</viewWidth>"
           "<viewHeight>0.35</viewHeight></camera><image>20 14</image><surface type=\"Sphere\"/>"
           "<light><position>5 6 9</position><intensity>" +
           intensity + " " + intensity + " " + intensity + "</intensity></light></scene>";
  }
  /// The mistake shows in these cases of the suite, in JSON.
  void show_in(const std::string& cases) const {
    write("built/fingerprints/lights-overwrite/mistake.json",
          "{\"schema\": 2, \"name\": \"n\", \"hint\": \"h\", \"step\": \"lights\", \"parts\": [], \"cases\": " + cases +
              ", \"no_picture\": [], \"in_places\": false}");
    for (const char* name : {"two-lights", "phong"})
      fs::copy_file(folder_ / "wrong.png",
                    folder_ / "built/fingerprints/lights-overwrite" / (std::string(name) + ".png"),
                    fs::copy_options::overwrite_existing);
  }
  int score(const std::string& more = "--filter lights-overwrite") {
    return plumb("suite score built --out score --mutants . " + more);
  }
  json matrix() const { return json::parse(content("score/kill-matrix.json")); }
};

TEST_F(SuiteScoreCommandTest, AMistakeThatIsCaughtByAllThatItNames) {
  show_in("[\"two-lights\", \"phong\"]");
  EXPECT_EQ(score(), 0) << said_ << complained_;
  EXPECT_THAT(said_, HasSubstr("lights-overwrite  ##\n"));
  EXPECT_THAT(said_, HasSubstr("caught by all that they name: 1 of 1 known mistakes\n"));
  EXPECT_THAT(said_, HasSubstr("Kill matrix: score/kill-matrix.html\n"));
  EXPECT_EQ(complained_, "");
  EXPECT_EQ(matrix()["mutants"][0]["verdict"], "caught");
  EXPECT_GT(matrix()["mutants"][0]["cells"]["phong"]["wrong_pixels"], 20);
  EXPECT_THAT(content("score/kill-matrix.csv"), HasSubstr("lights-overwrite,lights,caught,,"));
  EXPECT_THAT(content("score/kill-matrix.html"), HasSubstr("lights-overwrite, phong: "));
}

TEST_F(SuiteScoreCommandTest, ASurvivorEndsWithOne) {
  write("built/fingerprints/other", "");
  EXPECT_EQ(score(), 1) << said_ << complained_;
  EXPECT_THAT(said_, HasSubstr("lights-overwrite  !!  survives\n"));
  EXPECT_THAT(said_, HasSubstr("lights-overwrite (survives): two-lights: finds nothing wrong\n"));
  EXPECT_THAT(said_, HasSubstr("Cases that notice nothing: two-lights, phong\n"));
  show_in("[\"phong\"]");
  EXPECT_EQ(score(), 1);
  EXPECT_EQ(matrix()["mutants"][0]["verdict"], "partly_caught");
}

TEST_F(SuiteScoreCommandTest, ASuiteThatTheTracerItselfFailsIsOurFault) {
  show_in("[\"two-lights\"]");
  for (const char* bound : {"nominal", "low", "high"})
    fs::copy_file(folder_ / "wrong.png", folder_ / "built/envelopes/phong/course" / (std::string(bound) + ".png"),
                  fs::copy_options::overwrite_existing);
  EXPECT_EQ(score(), 3) << said_ << complained_;
  EXPECT_THAT(said_, HasSubstr("phong: not right with the tracer without mistakes: "));
}

TEST_F(SuiteScoreCommandTest, SaysWhatItNeeds) {
  EXPECT_EQ(plumb("suite score suite.toml"), 2);
  EXPECT_THAT(complained_, HasSubstr("holds no pictures of known mistakes, expected what 'plumb suite build' makes"));
  write("built/fingerprints/other", "");
  EXPECT_EQ(score("--filter nothing"), 2);
  EXPECT_THAT(complained_, HasSubstr("no known mistake matches 'nothing'"));
  EXPECT_EQ(score("--filter rotate-x-by-z"), 2);
  EXPECT_THAT(complained_, HasSubstr("rotate-x-by-z: this program with a known mistake does not exist, expected what"));
}

}  // namespace
}  // namespace plumb

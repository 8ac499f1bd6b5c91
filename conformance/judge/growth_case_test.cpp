// Cases of kind `growth`: suites, and programs that are not worth timing. The gate itself is tested in
// conformance/growth, and on programs that do render in tools/plumb.

#include "conformance/judge/grade_rules_fixture.h"
#include "conformance/judge/stop_verdict.h"

namespace plumb {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class GrowthCaseTest : public GradeRulesTest {
 protected:
  GrowthCaseTest() {
    for (const char* name : {"mesh.xml", "objects.xml"})
      fs::copy_file(fs::path(PLUMB_SOURCE_DIR) / "suites/growth" / name, folder_ / name);
  }
  static std::string a_growth(const std::string& id, const std::string& keys) {
    return "[[case]]\nid = \"" + id + "\"\nkind = \"growth\"\npoints = 10\n" + keys + "\n";
  }
  static inline const std::string kMesh = "measure = \"trace\"\nscene = \"mesh.xml\"\n";
  std::string complaint(const std::string& keys) const {
    write("suite.toml", suite() + a_growth("a", keys));
    try {
      read_suite(folder_ / "suite.toml");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  ResultSet grade_program(const std::string& script) const {
    write("sub/render.sh", script);
    return grade_by(suite() + a_growth("trace", kMesh) +
                    a_growth("build", "measure = \"build\"\nscene = \"mesh.xml\"\n"));
  }
};

TEST_F(GrowthCaseTest, SuitesAreReadStrictly) {
  EXPECT_EQ(complaint(kMesh), "");
  EXPECT_THAT(complaint("scene = \"mesh.xml\""),
              HasSubstr("'measure' of [[case]] is missing, expected trace or build"));
  EXPECT_THAT(complaint("measure = \"trase\"\nscene = \"mesh.xml\""), HasSubstr("did you mean 'trace'?"));
  EXPECT_THAT(complaint("measure = \"trace\"\nscene = \"objects.xml\""), HasSubstr("does not hold {mesh}"));
  EXPECT_THAT(complaint(kMesh + "object = \"x\""), HasSubstr("does not hold {objects}"));
  EXPECT_THAT(complaint(kMesh + "mesh_format = \"3ds\""), HasSubstr("expected msh, obj, ply, off, stl"));
  EXPECT_THAT(complaint(kMesh + "largest = 1000"), HasSubstr("'largest'"));
  EXPECT_THAT(complaint(kMesh + "reference = \"ref.png\""), HasSubstr("unknown key 'reference'"));
}

TEST_F(GrowthCaseTest, OneGateAnswersBothItsCases) {
  const ResultSet results = grade_program("echo run >> '" + (folder_ / "runs").string() + "'\n");
  EXPECT_THAT(outcomes(results), ElementsAre("trace: fail (no_picture)", "build: fail (no_picture)"));
  EXPECT_EQ(fs::file_size(folder_ / "runs"), 4u) << "one line, of the first run";
}

TEST_F(GrowthCaseTest, OnlyWholePicturesAreTimed) {
  EXPECT_THAT(outcomes(grade_program("cp answer \"$2\"\n")),  // 2 x 1 pixels, whatever was asked for
              ElementsAre("trace: fail (wrong_size)", "build: fail (wrong_size)"));
  EXPECT_THAT(outcomes(grade_program("echo text > \"$2\"\n")),
              ElementsAre("trace: fail (bad_picture)", "build: fail (bad_picture)"));
  EXPECT_THAT(outcomes(grade_program("kill -SEGV $$\n")),
              ElementsAre("trace: crash (signal)", "build: crash (signal)"));
}

TEST_F(GrowthCaseTest, APrerequisiteComesFirst) {
  write("sub/render.sh", "exit 0\n");
  const ResultSet results = grade_by(suite() + a_case("a") + a_growth("trace", kMesh + "requires = [\"a\"]"));
  EXPECT_THAT(outcomes(results), ElementsAre("a: fail (no_picture)", "trace: skipped (prerequisite)"));
}

}  // namespace
}  // namespace plumb

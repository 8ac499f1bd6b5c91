// The growth gate's subjects draw what plumb draws: they may differ in their time, and in nothing else.
#include <set>
#include <sstream>
#include <vector>

#include "meshes/formats/write_msh.h"
#include "meshes/generators/icosphere.h"
#include "tools/plumb/program_for_tests.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

const fs::path kSubjects = fs::path(PLUMB_SOURCE_DIR) / "examples/growth";

const std::vector<std::string> kNames = {"linear",     "simd-linear",     "median-split", "sah",        "grid",
                                         "one-leaf",   "no-pruning",      "axis-linear",  "slow-start", "two-threads",
                                         "per-object", "quadratic-build", "java-right",   "java-linear"};

constexpr const char* kLights = R"(
<light><position>4 5 -3</position><intensity>0.7 0.7 0.6</intensity></light>
<light><position>-3 1 4</position><intensity>0.3 0.3 0.4</intensity></light>
<shader name="matt" type="Lambertian"><diffuseColor>.7 .6 .9</diffuseColor></shader>
<shader name="shiny" type="Phong"><diffuseColor>.2 .6 .3</diffuseColor><specularColor>.3 .3 .3</specularColor>
<exponent>20</exponent></shader>
)";

/// An odd number of columns and rows, and a camera along an axis: its middle rays have components that are exactly 0.
std::string mesh_scene() {
  return std::string("<scene><camera><viewPoint>0 0 4</viewPoint><viewDir>0 0 -1</viewDir><viewUp>0 1 0</viewUp>") +
         "<projNormal>0 0 1</projNormal><projDistance>2</projDistance><viewWidth>1.5</viewWidth>" +
         "<viewHeight>1.5</viewHeight></camera><image>65 65</image>" + kLights +
         R"(<surface type="Mesh"><data>ball.msh</data><shader ref="shiny"/></surface></scene>)";
}

/// A slope of 400 spheres that shade each other.
std::string spheres_scene() {
  std::ostringstream text;
  text << "<scene><camera><viewPoint>1.5 1.2 4</viewPoint><viewDir>-1.5 -1.2 -4</viewDir><viewUp>0.1 1 0</viewUp>"
       << "<viewWidth>.8</viewWidth><viewHeight>.6</viewHeight></camera><image>80 60</image>" << kLights;
  for (int i = 0; i < 400; ++i)
    text << R"(<surface type="Sphere"><center>)" << 0.15 * (i % 20) - 1.4 << " " << 0.15 * (i / 20) - 1.4 << " "
         << 0.01 * (i * 37 % 50) << "</center><radius>" << 0.05 + 0.001 * (i % 30) << R"(</radius><shader ref=")"
         << (i % 2 == 0 ? "matt" : "shiny") << R"("/></surface>)";
  text << "</scene>";
  return text.str();
}

/// A ball whose normals have different lengths, which weigh in what is interpolated.
TriangleMesh uneven_ball() {
  TriangleMesh mesh = icosphere(2);
  for (std::size_t i = 0; i < mesh.normals.size(); ++i)
    mesh.normals[i] = (0.5 + 0.25 * static_cast<double>(i % 4)) * mesh.normals[i];
  return mesh;
}

class GrowthSubjectsTest : public ProgramTest, public testing::WithParamInterface<std::string> {};

TEST_P(GrowthSubjectsTest, DrawsAMeshAndManySpheresRight) {
  write_msh(uneven_ball(), folder_ / "ball.msh");
  write("mesh.xml", mesh_scene());
  write("spheres.xml", spheres_scene());
  ASSERT_EQ(plumb("render mesh.xml spheres.xml -o references"), 0) << complained_;
  write("suite.toml", R"([suite]
id = "growth-subjects"
schema = 1
own_runner = true
[runner]
overlay = ")" + (kSubjects / "shared").string() +
                          R"("
[[case]]
id = "mesh"
scene = "mesh.xml"
inputs = ["ball.msh"]
reference = "references/mesh.xml.png"
[[case]]
id = "spheres"
scene = "spheres.xml"
reference = "references/spheres.xml.png"
)");
  EXPECT_EQ(plumb("grade '" + (kSubjects / GetParam()).string() + "' --suite suite.toml --out out"), 0)
      << said_ << complained_ << content("out/build/log.txt");
  const auto found = verdicts(nlohmann::json::parse(content("out/results.json")));
  EXPECT_EQ(found, (std::map<std::string, std::string>{{"mesh", "pass"}, {"spheres", "pass"}}));
}

std::string as_identifier(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  for (char& c : name)
    if (c == '-') c = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, GrowthSubjectsTest, testing::ValuesIn(kNames), as_identifier);

TEST(GrowthSubjects, EachIsTestedAndHasItsExpectedVerdicts) {
  std::set<std::string> folders;
  for (const fs::directory_entry& entry : fs::directory_iterator(kSubjects))
    if (entry.is_directory() && entry.path().filename() != "shared") folders.insert(entry.path().filename());
  EXPECT_EQ(folders, std::set<std::string>(kNames.begin(), kNames.end()));
  std::ifstream stream(kSubjects / "EXPECTED.md");
  const std::string table{std::istreambuf_iterator<char>(stream), {}};
  for (const std::string& name : kNames) EXPECT_NE(table.find("| `" + name + "` | "), std::string::npos) << name;
}

}  // namespace
}  // namespace plumb

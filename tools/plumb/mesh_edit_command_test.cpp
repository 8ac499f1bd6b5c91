#include <regex>

#include "meshes/formats/write_msh.h"
#include "meshes/generators/icosphere.h"
#include "meshes/read_mesh.h"
#include "tools/plumb/program_for_tests.h"

namespace plumb {
namespace {

using testing::HasSubstr;

class MeshEditCommand : public ProgramTest {
 protected:
  MeshEditCommand() { write_msh(icosphere(2), folder_ / "ball.msh"); }

  TriangleMesh mesh(const std::string& name) const { return read_mesh(folder_ / name); }
  /// Writes two triangles that share a vertex alone.
  void write_bow_tie() const { write("bow.msh", "5 2 vertices 0 0 0 1 0 0 0 1 0 -1 0 0 0 -1 0 triangles 0 1 2 0 3 4"); }
};

TEST_F(MeshEditCommand, SimplifyReachesItsNumberAndSaysTheError) {
  ASSERT_EQ(plumb("mesh simplify ball.msh small.msh --triangles 100"), 0) << complained_;
  EXPECT_THAT(said_, HasSubstr("small.msh: 52 vertices, 100 triangles\n"));
  EXPECT_TRUE(std::regex_search(said_, std::regex("largest error: 0\\.0[0-9]+ "))) << said_;
  EXPECT_EQ(mesh("small.msh").triangles.size(), 100u);
  EXPECT_EQ(mesh("small.msh").normals.size(), 52u);
}

TEST_F(MeshEditCommand, SimplifySaysWhereItHadToStop) {
  ASSERT_EQ(plumb("mesh simplify ball.msh small.msh --triangles 1"), 0) << complained_;
  EXPECT_THAT(said_, HasSubstr("4 triangles are left of 320, not 1"));
}

TEST_F(MeshEditCommand, VerbsForManifoldMeshesNameTheFirstWrongPlace) {
  write_bow_tie();
  for (const char* verb : {"simplify bow.msh out.msh --triangles 1", "subdivide bow.msh out.msh --smooth"}) {
    EXPECT_EQ(plumb(std::string("mesh ") + verb), 2);
    EXPECT_THAT(complained_,
                HasSubstr("bow.msh: the triangles at vertex 0 form more than one fan; expected a manifold mesh"));
    EXPECT_THAT(complained_, HasSubstr("plumb mesh check"));
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out.msh"));
}

TEST_F(MeshEditCommand, SubdivideKeepsTheShapeOrSmoothsIt) {
  ASSERT_EQ(plumb("mesh subdivide ball.msh flat.msh --times 2"), 0) << complained_;
  EXPECT_THAT(said_, HasSubstr("flat.msh: 2562 vertices, 5120 triangles\n"));
  ASSERT_EQ(plumb("mesh subdivide ball.msh smooth.msh --smooth"), 0) << complained_;
  EXPECT_THAT(said_, HasSubstr("smooth.msh: 642 vertices, 1280 triangles\n"));
  EXPECT_THAT(said_, HasSubstr("normals: computed"));
  EXPECT_EQ(mesh("smooth.msh").normals.size(), 642u);
  write_bow_tie();
  EXPECT_EQ(plumb("mesh subdivide bow.msh flat.msh"), 0) << complained_;
}

TEST_F(MeshEditCommand, SubdivideRefusesWhatIsTooMuch) {
  EXPECT_EQ(plumb("mesh subdivide ball.msh out.msh --times 0"), 2);
  EXPECT_THAT(complained_, HasSubstr("--times 0: expected a number from 1 to 15"));
  EXPECT_EQ(plumb("mesh subdivide ball.msh out.msh --times 15"), 2);
  EXPECT_THAT(complained_, HasSubstr("would make 343597383680 triangles"));
}

TEST_F(MeshEditCommand, TransformAppliesItsOptionsOneAfterAnother) {
  write("point.msh", "1 0 vertices 1 2 3 triangles");
  const auto moved = [&](const std::string& options) {
    EXPECT_EQ(plumb("mesh transform point.msh out.msh " + options), 0) << complained_;
    return mesh("out.msh").positions.at(0);
  };
  EXPECT_EQ(moved("--translate 1,0,0 --scale 2"), (Point3{4, 4, 6}));
  EXPECT_EQ(moved("--scale 2 --translate 1,0,0"), (Point3{3, 4, 6}));
  EXPECT_EQ(moved("--translate=-1,0,0 --scale 1,2,3 --translate 1,1,1"), (Point3{1, 5, 10}));
  EXPECT_EQ(moved("--rotate 90,0,90"), (Point3{3, 1, 2}));  // about x: 1 -3 2; then about z
  EXPECT_EQ(moved("--scale 2 --matrix '1 0 0 0.5  0 0 1 0  0 1 0 0'"), (Point3{2.5, 6, 4}));
  EXPECT_THAT(said_, HasSubstr("mirrored: every triangle is reversed"));
}

TEST_F(MeshEditCommand, TransformFitsWhatCameBeforeIntoTheUnitCube) {
  write("box.msh", "2 0 vertices 0 0 0 4 2 2 triangles");
  ASSERT_EQ(plumb("mesh transform box.msh out.msh --scale 1,4,1 --fit-unit-cube --translate 1,0,0"), 0) << complained_;
  EXPECT_EQ(mesh("out.msh").positions, (std::vector<Point3>{{.75, -.5, -.125}, {1.25, .5, .125}}));
}

TEST_F(MeshEditCommand, TransformKeepsTheFrontOutside) {
  ASSERT_EQ(plumb("mesh transform ball.msh out.msh --scale=-1,1,1"), 0) << complained_;
  const TriangleMesh ball = mesh("ball.msh"), mirrored = mesh("out.msh");
  EXPECT_EQ(mirrored.triangles[0],
            (std::array<std::uint32_t, 3>{ball.triangles[0][0], ball.triangles[0][2], ball.triangles[0][1]}));
  EXPECT_NEAR(mirrored.normals[0].x, -ball.normals[0].x, 1e-15);
}

TEST_F(MeshEditCommand, TransformRefusesWhatIsNoTransform) {
  const auto refused = [&](const std::string& options) {
    EXPECT_EQ(plumb("mesh transform ball.msh out.msh " + options), 2) << said_;
    return complained_;
  };
  EXPECT_THAT(refused(""), HasSubstr("nothing is asked, expected --translate"));
  EXPECT_THAT(refused("--scale 1,0,1"), HasSubstr("singular"));
  EXPECT_THAT(refused("--translate 1,2"), HasSubstr("--translate"));
  EXPECT_THAT(refused("--scale big"), HasSubstr("--scale"));
  EXPECT_THAT(refused("--matrix 1,2,3"), HasSubstr("--matrix"));
  EXPECT_THAT(refused("--scale 1e200 --scale 1e200"), HasSubstr("expected"));
  write("point.msh", "1 0 vertices 1 2 3 triangles");
  EXPECT_EQ(plumb("mesh transform point.msh out.msh --fit-unit-cube"), 2);
  EXPECT_THAT(complained_, HasSubstr("expected one with an extent"));
}

TEST_F(MeshEditCommand, NormalsAreComputedRemovedAndFlipped) {
  ASSERT_EQ(plumb("mesh normals ball.msh bare.msh --remove"), 0) << complained_;
  EXPECT_TRUE(mesh("bare.msh").normals.empty());
  ASSERT_EQ(plumb("mesh normals bare.msh again.msh --weight angle"), 0) << complained_;
  const TriangleMesh ball = mesh("ball.msh");
  const TriangleMesh again = mesh("again.msh");
  ASSERT_EQ(again.normals.size(), ball.normals.size());
  for (std::size_t i = 0; i < ball.normals.size(); ++i)
    EXPECT_GT(dot(ball.normals[i], as_vector(again.normals[i])), .99) << i;
  ASSERT_EQ(plumb("mesh normals bare.msh sharp.msh --crease 1"), 0) << complained_;
  EXPECT_THAT(said_, HasSubstr("creases: 798 vertices repeated"));  // 320 triangles on their own have 960
  ASSERT_EQ(plumb("mesh normals ball.msh inside.msh --flip"), 0) << complained_;
  EXPECT_EQ(mesh("inside.msh").normals[0], -ball.normals[0]);
  write("point.msh", "1 0 vertices 1 2 3 triangles");
  ASSERT_EQ(plumb("mesh normals point.msh out.msh"), 0) << complained_;
  EXPECT_THAT(said_, HasSubstr("normals: (0, 0, 1) at 1 vertices"));
}

TEST_F(MeshEditCommand, NormalsRefuseWhatDoesNotGoTogether) {
  for (const char* options : {"--weight volume", "--crease 181", "--crease=-1", "--remove --flip",
                              "--remove --crease 3", "--flip --weight area"}) {
    EXPECT_EQ(plumb(std::string("mesh normals ball.msh out.msh ") + options), 2) << options;
    EXPECT_FALSE(complained_.empty());
  }
}

}  // namespace
}  // namespace plumb

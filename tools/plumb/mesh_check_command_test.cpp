// `plumb mesh check`, run as a program.
#include "tools/plumb/program_for_tests.h"

namespace plumb {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class MeshCheckCommandTest : public ProgramTest {
 protected:
  MeshCheckCommandTest() {
    write("sound.obj", kVertices + kFaces + "f 2 3 4\n");
    write("open.obj", kVertices + kFaces);
    write("thin.obj", kVertices + "v 2 0 0\n" + kFaces + "f 2 3 4\nf 1 2 5\n");
    write("broken.obj", "v 1 2\n");
  }

  static inline const std::string kVertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  static inline const std::string kFaces = "f 1 3 2\nf 1 2 4\nf 1 4 3\n";
};

TEST_F(MeshCheckCommandTest, ASoundMeshExitsZero) {
  EXPECT_EQ(plumb("mesh check sound.obj"), 0) << complained_;
  EXPECT_THAT(said_,
              AllOf(HasSubstr("sound.obj: 4 vertices, 4 triangles, 6 edges, 1 component, Euler characteristic 2"),
                    HasSubstr("box: (0, 0, 0) to (1, 1, 1)"), HasSubstr("closed, manifold, oriented outward"),
                    HasSubstr("no fault"), HasSubstr("fit for escape checks"), HasSubstr("not fit for smooth checks")));
  EXPECT_EQ(complained_, "");
}

TEST_F(MeshCheckCommandTest, AFaultIsToldAndExitsOne) {
  EXPECT_EQ(plumb("mesh check sound.obj open.obj"), 1) << complained_;
  EXPECT_THAT(said_, AllOf(HasSubstr("open.obj: 4 vertices, 3 triangles"), HasSubstr("not closed, manifold, oriented;"),
                           HasSubstr("fault: 3 edges have a triangle on one side only"),
                           HasSubstr("(triangles 0, 1, 2)"), HasSubstr("not fit for escape checks")));
}

TEST_F(MeshCheckCommandTest, FitnessForOneUseDecidesAlone) {
  EXPECT_EQ(plumb("mesh check open.obj --for triangle"), 0);
  EXPECT_EQ(plumb("mesh check open.obj --for growth"), 0);
  EXPECT_EQ(plumb("mesh check open.obj --for inside"), 1);
  EXPECT_EQ(plumb("mesh check sound.obj --for smooth"), 1);
  EXPECT_EQ(plumb("mesh check sound.obj --for escape"), 0);
  EXPECT_EQ(plumb("mesh check sound.obj --for escape --no-self-intersections"), 1);
  EXPECT_THAT(said_, HasSubstr("self-intersections were not looked for"));
  EXPECT_EQ(plumb("mesh check sound.obj --for grwoth"), 2);
  EXPECT_THAT(complained_, AllOf(HasSubstr("triangle|growth|smooth|inside|escape"), HasSubstr("growth")));
}

TEST_F(MeshCheckCommandTest, JsonHoldsTheSameFacts) {
  EXPECT_EQ(plumb("mesh check thin.obj --json"), 1);
  const json said = json::parse(said_);
  EXPECT_EQ(said["schema"], 1);
  ASSERT_EQ(said["meshes"].size(), 1u);
  const json& mesh = said["meshes"][0];
  EXPECT_EQ(mesh["file"], "thin.obj");
  EXPECT_EQ(mesh["triangles"], 5);
  EXPECT_EQ(mesh["bounds"]["max"], json({2, 1, 1}));
  EXPECT_EQ(mesh["closed"], false);
  EXPECT_EQ(mesh["outward"], nullptr);
  EXPECT_EQ(mesh["zero_area"], json({{"count", 1}, {"examples", {4}}}));
  EXPECT_EQ(mesh["self_intersections"]["count"], 0);
  EXPECT_EQ(mesh["fitness"]["triangle"]["fit"], false);
  EXPECT_THAT(std::string(mesh["fitness"]["triangle"]["reason"]), HasSubstr("1 triangle has no area"));
  std::vector<std::string> faults;
  for (const json& fault : mesh["faults"]) faults.push_back(fault["id"]);
  EXPECT_THAT(faults, ElementsAre("boundary_edges", "edges_of_many", "zero_area"));
  EXPECT_EQ(plumb("mesh check sound.obj --json --no-self-intersections"), 0);
  EXPECT_EQ(json::parse(said_)["meshes"][0]["self_intersections"], nullptr);
  EXPECT_EQ(json::parse(said_)["meshes"][0]["outward"], true);
}

TEST_F(MeshCheckCommandTest, WhatCannotBeReadExitsTwoAndTheRestIsChecked) {
  EXPECT_EQ(plumb("mesh check broken.obj missing.ply sound.obj"), 2);
  EXPECT_THAT(complained_, AllOf(HasSubstr("broken.obj"), HasSubstr("missing.ply")));
  EXPECT_THAT(said_, AllOf(HasSubstr("sound.obj: 4 vertices"), Not(HasSubstr("broken"))));
  EXPECT_EQ(plumb("mesh check broken.obj sound.obj --json"), 2);
  EXPECT_THAT(std::string(json::parse(said_)["meshes"][0]["error"]), HasSubstr("broken.obj"));
  EXPECT_EQ(plumb("mesh check"), 2);
}

}  // namespace
}  // namespace plumb

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "meshes/generators/icosphere.h"
#include "meshes/validation/mesh_report.h"
#include "meshes/validation/meshes_for_tests.h"

namespace plumb {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The uses that a mesh is fit for, parted by blanks; that reasons are given for the others alone is expected.
std::string fit_for(const TriangleMesh& mesh, bool self_intersections = true) {
  std::string names;
  for (const MeshFitness& use : mesh_fitness(check_mesh(mesh, {self_intersections, {}}))) {
    EXPECT_EQ(use.fit, use.reason.empty()) << use.check;
    EXPECT_FALSE(use.needs.empty());
    if (use.fit) names += (names.empty() ? "" : " ") + std::string(use.check);
  }
  return names;
}

std::vector<std::string> faults_of(const TriangleMesh& mesh) {
  std::vector<std::string> ids;
  for (const MeshFinding& fault : mesh_faults(check_mesh(mesh))) ids.emplace_back(fault.id);
  return ids;
}

TriangleMesh with(TriangleMesh mesh, const std::function<void(TriangleMesh&)>& change) {
  change(mesh);
  return mesh;
}

TEST(MeshFitness, OfEachKindOfMesh) {
  const TriangleMesh sphere = icosphere(1);
  const struct {
    std::string name;
    TriangleMesh mesh;
    std::string uses;
  } rows[] = {
      {"smooth and closed", sphere, "triangle growth smooth inside escape"},
      {"without normals", cube(), "triangle growth inside escape"},
      {"nothing", {}, ""},
      {"a hole", with(sphere, [](auto& m) { m.triangles.pop_back(); }), "triangle growth smooth"},
      {"inside out", turned_inside_out(cube()), "triangle growth"},
      {"one flipped", with(cube(), [](auto& m) { std::swap(m.triangles[0][0], m.triangles[0][1]); }),
       "triangle growth"},
      {"a normal too long", with(sphere, [](auto& m) { m.normals[0] = 2 * m.normals[0]; }), "triangle inside escape"},
      {"a normal behind", with(sphere, [](auto& m) { m.normals[0] = -m.normals[0]; }), "triangle inside escape"},
      {"crossing", joined(cube(), moved(cube(), {0.5, 0.5, 0.5})), "triangle growth inside"},
      {"no area",
       with(cube(),
            [](auto& m) {
              m.triangles.push_back({0, 0, 1});
            }),
       "inside"},
      {"twice",
       with(cube(),
            [](auto& m) {
              m.triangles.push_back({0, 4, 6});
            }),
       "triangle"},
      {"unused", with(cube(), [](auto& m) { m.positions.push_back({}); }), "triangle growth inside escape"},
  };
  for (const auto& row : rows) EXPECT_EQ(fit_for(row.mesh), row.uses) << row.name;
}

TEST(MeshFitness, WhatWasNotLookedForIsNotPresumed) {
  EXPECT_EQ(fit_for(cube(), false), "triangle growth inside");
  EXPECT_THAT(mesh_fitness(check_mesh(cube(), {false, {}})).back().reason, HasSubstr("not looked for"));
  EXPECT_THAT(mesh_faults(check_mesh(cube(), {false, {}})), IsEmpty());
}

TEST(MeshFaults, AreSaidInWordsWithExamples) {
  EXPECT_THAT(faults_of(icosphere(2)), IsEmpty());
  EXPECT_THAT(faults_of({}), ElementsAre("triangles"));
  EXPECT_THAT(faults_of(turned_inside_out(cube())), ElementsAre("outward"));
  const TriangleMesh many = with(cube(), [](auto& m) {
    m.triangles.pop_back();
    m.triangles.push_back({3, 3, 3});
    m.positions.resize(20, {1, 2, 3});
  });
  EXPECT_THAT(faults_of(many),
              ElementsAre("boundary_edges", "repeated_corners", "duplicate_vertices", "unused_vertices"));
  const std::vector<MeshFinding> faults = mesh_faults(check_mesh(many));
  EXPECT_EQ(faults[1].sentence, "1 triangle names the same vertex twice (triangles 11)");
  EXPECT_EQ(faults[3].sentence, "12 vertices belong to no triangle (vertices 8, 9, 10, 11, 12, ...)");
}

}  // namespace
}  // namespace plumb

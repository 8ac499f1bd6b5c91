#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "meshes/generators/icosphere.h"
#include "meshes/validation/mesh_report.h"
#include "meshes/validation/meshes_for_tests.h"

namespace plumb {
namespace {

constexpr double kTiny = std::numeric_limits<double>::denorm_min();

struct Counted {
  std::uint64_t count;
  std::vector<std::uint32_t> examples;
};
using Found = std::map<std::string, Counted>;

bool operator==(const Counted& a, const Counted& b) { return a.count == b.count && a.examples == b.examples; }
void PrintTo(const Counted& counted, std::ostream* out) {
  *out << counted.count << testing::PrintToString(counted.examples);
}

/// Every fault that a report counts, by its field.
Found found(const MeshReport& report) {
  Found all;
  for (const auto& [name, field] : {std::pair{"unused_vertices", &MeshReport::unused_vertices},
                                    {"duplicate_vertices", &MeshReport::duplicate_vertices},
                                    {"seam_vertices", &MeshReport::seam_vertices},
                                    {"repeated_corners", &MeshReport::repeated_corners},
                                    {"zero_area", &MeshReport::zero_area},
                                    {"duplicate_triangles", &MeshReport::duplicate_triangles},
                                    {"boundary_edges", &MeshReport::boundary_edges},
                                    {"edges_of_many", &MeshReport::edges_of_many},
                                    {"misoriented_edges", &MeshReport::misoriented_edges},
                                    {"vertices_of_many_fans", &MeshReport::vertices_of_many_fans},
                                    {"normals_not_unit", &MeshReport::normals_not_unit},
                                    {"normals_against", &MeshReport::normals_against}})
    if (const MeshFault& fault = report.*field; fault.count > 0) all[name] = {fault.count, fault.examples};
  if (report.self_intersections && report.self_intersections->count > 0)
    all["self_intersections"] = {report.self_intersections->count, report.self_intersections->examples};
  return all;
}

/// A mesh, and all that shall be found: the faults, components, the Euler characteristic and the shape (c closed,
/// m manifold, o oriented, + or - for outward and inward).
struct Case {
  std::string name;
  TriangleMesh mesh;
  Found faults;
  std::uint64_t components;
  std::int64_t euler;
  std::string shape;
};

std::string shape_of(const MeshReport& report) {
  return std::string(report.closed ? "c" : "") + (report.manifold ? "m" : "") + (report.oriented ? "o" : "") +
         (report.outward ? *report.outward ? "+" : "-" : "");
}

void expect(const Case& one) {
  SCOPED_TRACE(one.name);
  const MeshReport report = check_mesh(one.mesh);
  EXPECT_EQ(found(report), one.faults);
  EXPECT_EQ(report.components, one.components);
  EXPECT_EQ(report.euler_characteristic, one.euler);
  EXPECT_EQ(shape_of(report), one.shape);
  EXPECT_EQ(report.vertices, one.mesh.positions.size());
  EXPECT_EQ(report.triangles, one.mesh.triangles.size());
}

TriangleMesh cube_with(const std::function<void(TriangleMesh&)>& change) {
  TriangleMesh mesh = cube();
  change(mesh);
  return mesh;
}

/// Vertex 8 in the middle of the edge from 0 to 1, which the triangle above knows and the one below does not; triangle
/// 13, without area, lies between them. The surface is closed, but triangles meet along parts of their edges.
TriangleMesh cube_with_flat_filler() {
  TriangleMesh mesh = cube();
  mesh.positions.push_back({0.5, 0, 0});
  mesh.triangles[4] = {0, 8, 5};
  mesh.triangles.push_back({8, 1, 5});
  mesh.triangles.push_back({0, 1, 8});
  return mesh;
}

std::vector<Case> single_faults() {
  const auto add_triangle = [](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return cube_with([=](TriangleMesh& mesh) { mesh.triangles.push_back({a, b, c}); });
  };
  return {
      {"sound", cube(), {}, 1, 2, "cmo+"},
      {"hole",
       cube_with([](TriangleMesh& mesh) { mesh.triangles.erase(mesh.triangles.begin()); }),
       {{"boundary_edges", {3, {0, 4, 10}}}},
       1,
       1,
       "mo"},
      {"unused vertex",
       cube_with([](TriangleMesh& mesh) {
         mesh.positions.push_back({5, 5, 5});
       }),
       {{"unused_vertices", {1, {8}}}},
       1,
       2,
       "cmo+"},
      {"duplicate vertex",
       cube_with([](TriangleMesh& mesh) {
         mesh.positions.push_back({-0.0, -0.0, 0.0});
         mesh.triangles[0][0] = 8;
       }),
       {{"duplicate_vertices", {1, {8}}}},
       1,
       2,
       "cmo+"},
      {"seam",
       cube_with([](TriangleMesh& mesh) {
         mesh.positions.push_back({0, 0, 0});
         mesh.triangles[0][0] = 8;
         mesh.texcoords.resize(9);
         mesh.texcoords[8] = {1, 0};
       }),
       {{"seam_vertices", {1, {8}}}},
       1,
       2,
       "cmo+"},
      {"repeated corner", add_triangle(0, 1, 0), {{"repeated_corners", {1, {12}}}}, 1, 2, "cmo+"},
      {"no area",
       cube_with_flat_filler(),
       {{"zero_area", {1, {13}}}, {"self_intersections", {3, {4, 9, 12}}}},
       1,
       2,
       "cmo+"},
      {"flipped triangle",
       cube_with([](TriangleMesh& mesh) { std::swap(mesh.triangles[0][0], mesh.triangles[0][1]); }),
       {{"misoriented_edges", {3, {0}}}},
       1,
       2,
       "cm"},
      {"inside out", turned_inside_out(cube()), {}, 1, 2, "cmo-"},
      {"bow tie",
       {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
        {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 4, 5}, {0, 6, 4}, {0, 5, 6}, {4, 6, 5}},
        {},
        {}},
       {{"vertices_of_many_fans", {1, {0}}}},
       2,
       3,
       "co+"},
      {"two tetrahedra at an edge",
       joined(tetrahedron(), scaled(tetrahedron(), {1, -1, -1})),
       {{"duplicate_vertices", {2, {4, 5}}}, {"edges_of_many", {1, {0}}}},
       1,
       3,
       "c"},
      {"crossing cubes",
       joined(cube(), moved(cube(), {0.5, 0.25, 0.125})),
       {{"self_intersections", {12, {2, 3, 6, 7, 10}}}},
       2,
       4,
       "cmo+"},
      {"nested shells", joined(cube(), moved(scaled(cube(), {0.5, 0.5, 0.5}), {0.25, 0.25, 0.25})), {}, 2, 4, "cmo+"},
      {"a cavity",
       joined(cube(), moved(turned_inside_out(scaled(cube(), {0.5, 0.5, 0.5})), {0.25, 0.25, 0.25})),
       {},
       2,
       4,
       "cmo+"},
  };
}

TEST(CheckMesh, FindsEachFaultAlone) {
  const std::vector<Case> cases = single_faults();
  for (const Case& one : cases) expect(one);
  EXPECT_EQ(cases.size(), 14u);
}

std::vector<Case> several_faults() {
  return {
      {"nothing", {}, {}, 0, 0, "mo"},
      {"one triangle",
       {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}, {}},
       {{"boundary_edges", {3, {0}}}},
       1,
       1,
       "mo"},
      {"a triangle twice",
       cube_with([](TriangleMesh& mesh) {
         mesh.triangles.push_back({6, 0, 4});
       }),
       {{"duplicate_triangles", {1, {12}}}, {"edges_of_many", {3, {0}}}, {"self_intersections", {2, {0, 12}}}},
       1,
       3,
       "c"},
      {"a pillow: front and back at one place",
       {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}, {}, {}},
       {{"duplicate_triangles", {1, {1}}}, {"self_intersections", {2, {0, 1}}}},
       1,
       2,
       "cmo-"},
      {"two corners at one place",
       {{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, {{0, 1, 2}}, {}, {}},
       {{"duplicate_vertices", {1, {2}}}, {"zero_area", {1, {0}}}},
       0,
       0,
       "mo"},
      {"overlapping in a plane, at an edge",
       {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 0, 3}}, {}, {}},
       {{"boundary_edges", {4, {0, 1}}}, {"self_intersections", {2, {0, 1}}}},
       1,
       1,
       "mo"},
      {"a vertex within an edge",
       {{{0, 0, 0}, {2, 0, 0}, {1, 2, 0}, {1, 0, 0}, {0, -1, 0}, {2, -1, 0}}, {{0, 1, 2}, {3, 4, 5}}, {}, {}},
       {{"boundary_edges", {6, {0, 1}}}, {"self_intersections", {2, {0, 1}}}},
       2,
       2,
       "mo"},
      {"cubes that touch at a face, each with its own vertices",
       joined(cube(), moved(cube(), {1, 0, 0})),
       {{"duplicate_vertices", {4, {8, 10, 12, 14}}},
        {"duplicate_triangles", {2, {12, 13}}},
        {"edges_of_many", {5, {2, 3}}},
        {"self_intersections", {4, {2, 3, 12, 13}}}},
       1,
       5,
       "c"},
  };
}

TEST(CheckMesh, FindsFaultsThatComeTogether) {
  for (const Case& one : several_faults()) expect(one);
}

/// A strip of five triangles whose ends are joined the wrong way round.
TEST(CheckMesh, AMobiusStripCannotBeOriented) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < 5; ++i) {
    mesh.positions.push_back({double(i), double(i * i), double(i * i * i)});
    mesh.triangles.push_back({i, (i + 1) % 5, (i + 2) % 5});
    if (i % 2 == 1) std::swap(mesh.triangles.back()[0], mesh.triangles.back()[1]);
  }
  const MeshReport report = check_mesh(mesh, {.self_intersections = false, .progress = {}});
  EXPECT_EQ(report.edges, 10u);
  EXPECT_EQ(report.boundary_edges.count, 5u);
  EXPECT_EQ(report.euler_characteristic, 0);
  EXPECT_GE(report.misoriented_edges.count, 1u);
  EXPECT_EQ(shape_of(report), "m");
  EXPECT_FALSE(report.self_intersections);
}

/// A grid of squares that is closed straight in one direction and mirrored in the other.
TEST(CheckMesh, AKleinBottleIsClosedAndCannotBeOriented) {
  constexpr std::uint32_t kSide = 5;
  TriangleMesh mesh;
  const auto vertex = [](std::uint32_t i, std::uint32_t j) {
    return i == kSide ? (kSide - j) % kSide : i * kSide + j % kSide;
  };
  for (std::uint32_t i = 0; i < kSide; ++i) {
    for (std::uint32_t j = 0; j < kSide; ++j) {
      const double n = i * kSide + j;
      mesh.positions.push_back({n, n * n, n * n * n});
      const std::uint32_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
      mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
    }
  }
  const MeshReport report = check_mesh(mesh);
  EXPECT_EQ(report.edges, 75u);
  EXPECT_EQ(report.euler_characteristic, 0);
  EXPECT_EQ(report.misoriented_edges.count, kSide);
  EXPECT_EQ(shape_of(report), "cm");
  EXPECT_EQ(report.components, 1u);
}

TEST(CheckMesh, DecidesAtTheEndsOfTheRangeOfDoubles) {
  const Vec3 factors[] = {{1e300, 1e300, 1e300},   {1e-300, 1e-300, 1e-300}, {kTiny, kTiny, kTiny},
                          {1e300, 1, 1e-300},      {1e-300, 1e300, kTiny},   {8 * kTiny, 1e308, 1e-10},
                          {1e-300, 1e-300, 1e300}, {0x1p1023, 0x1p1023, 1}};
  int checked = 0;
  for (const Vec3& by : factors) {
    for (Case& one : single_faults()) {
      if (one.name == "crossing cubes" || one.name == "nested shells" || one.name == "a cavity") continue;
      if (one.name == "unused vertex" || one.name == "no area") continue;  // 5 is too large, a half too small
      one.name += " times " + testing::PrintToString(by.x) + " " + testing::PrintToString(by.y);
      one.mesh = scaled(one.mesh, by);
      expect(one);
      ++checked;
    }
  }
  EXPECT_EQ(checked, 8 * 9);
  for (const double by : {1e-307, 1e300}) {
    for (Case& one : single_faults()) {
      one.mesh = scaled(one.mesh, {by, by, by});
      expect(one);
    }
  }
}

/// Six times the volume is 8, beside products of 2^159.
TEST(CheckMesh, OrientationFarFromZeroIsExact) {
  const double far = 0x1p53;
  const TriangleMesh mesh = moved(scaled(tetrahedron(), {2, 2, 2}), {far, -far, far});
  EXPECT_EQ(shape_of(check_mesh(mesh)), "cmo+");
  EXPECT_EQ(shape_of(check_mesh(turned_inside_out(mesh))), "cmo-");
}

TEST(CheckMesh, AreaIsExact) {
  const Point3 p{0.1, 0.7, -0.3}, twice{0.2, 1.4, -0.6}, fourfold{0.4, 2.8, -1.2};
  Point3 beside = fourfold;
  beside.y = std::nextafter(beside.y, 3);
  EXPECT_EQ(check_mesh({{p, twice, fourfold}, {{0, 1, 2}}, {}, {}}).zero_area.count, 1u);
  EXPECT_EQ(check_mesh({{p, twice, beside}, {{0, 1, 2}}, {}, {}}).zero_area.count, 0u);
}

TEST(CheckMesh, NormalsAreUnitAndInFront) {
  TriangleMesh mesh = icosphere(2);
  EXPECT_EQ(found(check_mesh(mesh)), Found{});
  mesh.normals[3] = 1.00001 * mesh.normals[3];
  mesh.normals[7] = {0, 0, 0};
  mesh.normals[8] = 1.0000001 * mesh.normals[8];
  EXPECT_EQ(found(check_mesh(mesh)), (Found{{"normals_not_unit", {2, {3, 7}}}}));

  mesh = icosphere(2);
  mesh.normals[0] = -mesh.normals[0];
  std::vector<std::uint32_t> around;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
    for (const std::uint32_t vertex : mesh.triangles[i])
      if (vertex == 0) around.push_back(i);
  EXPECT_EQ(found(check_mesh(mesh)), (Found{{"normals_against", {around.size(), around}}}));

  // Along the triangle is not behind it; a bit below is.
  TriangleMesh flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {{1, 0, 0}, {1, 0, kTiny}, {1, 0, -kTiny}}, {}};
  const MeshReport report = check_mesh(flat);
  EXPECT_EQ(report.normals_not_unit.count, 0u);
  EXPECT_EQ(report.normals_against, (MeshFault{1, {0}}));
}

TEST(CheckMesh, ExamplesAreTheFirstOnes) {
  TriangleMesh mesh;
  for (int i = 0; i < 100; ++i) mesh.positions.push_back({double(i), 0, 0});
  EXPECT_EQ(check_mesh(mesh).unused_vertices, (MeshFault{100, {0, 1, 2, 3, 4}}));
  MeshFault fault;
  for (const std::uint32_t index : {9u, 5u, 5u, 7u, 1u, 8u, 3u, 3u, 2u, 10u}) fault.add(index);
  EXPECT_EQ(fault, (MeshFault{10, {1, 2, 3, 5, 7}}));
}

TEST(CheckMesh, TellsItsProgress) {
  std::vector<double> shares;
  check_mesh(icosphere(5), {.self_intersections = true, .progress = [&](double share) { shares.push_back(share); }});
  EXPECT_GT(shares.size(), 100u);
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  EXPECT_EQ(shares.front(), 0);
  EXPECT_EQ(shares.back(), 1);
}

}  // namespace
}  // namespace plumb

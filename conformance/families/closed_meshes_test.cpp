#include "conformance/families/closed_meshes.h"

#include <gtest/gtest.h>

#include <bit>
#include <map>

#include "conformance/families/hardness_for_tests.h"
#include "conformance/families/placed.h"

namespace plumb {
namespace {

using namespace textbook;

constexpr plumb_precision kPrecisions[] = {PLUMB_FLOAT, PLUMB_DOUBLE};

std::vector<ClosedSurface> all_closed(plumb_precision precision) {
  std::vector<ClosedSurface> list = closed_meshes(precision);
  const std::vector<ClosedSurface> solids = closed_solids(precision);
  const std::vector<ClosedSurface> placed = under_matrices(solids, precision);
  const std::vector<ClosedSurface> meshes = under_matrices({list[0], list[4]}, precision);
  for (const auto* more : {&solids, &placed, &meshes}) list.insert(list.end(), more->begin(), more->end());
  return list;
}

/// Six times the signed volume of the face's pyramid over `apex`.
Quad volume(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& face, const Triple<Quad>& apex) {
  const auto at = [&](std::size_t i) { return to<Quad>(mesh.positions[face[i]]) - apex; };
  return dot(at(0), cross(at(1), at(2)));
}

/// Each edge once in each direction, and each face strictly turned away from the middle: then the faces cover each
/// direction from there exactly once, so the surface is closed and does not meet itself.
TEST(ClosedMeshes, AreClosedAndSeenWholeFromTheMiddle) {
  for (const plumb_precision precision : kPrecisions) {
    for (const ClosedSurface& closed : closed_meshes(precision)) {
      const TriangleMesh& mesh = *closed.surface.shape.mesh;
      std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
      for (const auto& face : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) ++edges[{face[i], face[(i + 1) % 3]}];
        EXPECT_GT(static_cast<double>(volume(mesh, face, to<Quad>(middle_of(mesh)))), 0) << closed.name;
      }
      for (const auto& [edge, times] : edges) {
        EXPECT_EQ(times, 1) << closed.name;
        EXPECT_TRUE(edges.contains({edge.second, edge.first})) << closed.name;
      }
      // Euler: a sphere, not several nor a torus.
      EXPECT_EQ(mesh.positions.size() + mesh.triangles.size(), edges.size() / 2 + 2) << closed.name;
    }
  }
}

TEST(ClosedMeshes, HaveRepresentableNumbersAndOwnNames) {
  for (const plumb_precision precision : kPrecisions) {
    std::map<std::string, int> names;
    int numbers = 0;
    const auto see = [&](double x) {
      ++numbers;
      EXPECT_TRUE(precision == PLUMB_DOUBLE || nearest_float(x) == x) << std::hexfloat << x;
    };
    for (const ClosedSurface& closed : all_closed(precision)) {
      EXPECT_EQ(++names[closed.name], 1) << closed.name;
      const Shape& shape = closed.surface.shape;
      for (const double x : {shape.center.x, shape.center.y, shape.center.z, shape.radius, shape.height, shape.tip_z,
                             shape.min.x, shape.min.y, shape.min.z, shape.max.x, shape.max.y, shape.max.z}) {
        see(x);
      }
      if (shape.mesh) {
        for (const Point3& p : shape.mesh->positions) see(p.x), see(p.y), see(p.z);
      }
      for (const auto& row : closed.surface.world_from_object) {
        for (const double entry : row) see(entry);
      }
      for (const Ray& ray : leak_rays(closed, 1, 50, precision)) {
        for (int axis = 0; axis < 3; ++axis) see(ray.origin[axis]), see(ray.direction[axis]);
        EXPECT_NE(ray.direction, Vec3{}) << closed.name;
      }
    }
    EXPECT_GT(numbers, 20000);
  }
}

bool strictly_inside(const Shape& shape, const Triple<Quad>& o) {
  if (shape.kind == ShapeKind::mesh) {
    for (const auto& face : shape.mesh->triangles) {
      if (volume(*shape.mesh, face, o) <= 0) return false;
    }
    return true;
  }
  if (shape.kind == ShapeKind::box) {
    const Triple<Quad> low = o - to<Quad>(shape.min), high = to<Quad>(shape.max) - o;
    return low.x > 0 && low.y > 0 && low.z > 0 && high.x > 0 && high.y > 0 && high.z > 0;
  }
  const Triple<Quad> f = o - to<Quad>(shape.center);
  const Quad r = shape.radius, half = static_cast<Quad>(shape.height) / 2;
  if (shape.kind == ShapeKind::sphere) return dot(f, f) < r * r;
  if (!(magnitude(f.z) < half)) return false;
  const Quad tip = static_cast<Quad>(shape.tip_z) - static_cast<Quad>(shape.center.z);
  const Quad widest = shape.kind == ShapeKind::cone ? r * (f.z - tip) / tip : r;
  return f.x * f.x + f.y * f.y < widest * widest;
}

int hits_of(const TriangleMesh& mesh, const Ray& ray, Quad& margin) {
  int hits = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto answer = triangle<Quad>({mesh.positions[a], mesh.positions[b], mesh.positions[c]}, line_of<Quad>(ray));
    hits += answer.hit ? 1 : 0;
    if (answer.margin < margin) margin = answer.margin;
  }
  return hits;
}

/// Of convex meshes and solids, in object space. From inside of the bumpy mesh, an odd number of hits.
TEST(LeakRays, BeginStrictlyInside) {
  for (const plumb_precision precision : kPrecisions) {
    int rays = 0;
    for (const ClosedSurface& closed : all_closed(precision)) {
      const bool convex = !closed.name.starts_with("bumpy");
      for (const Ray& ray : leak_rays(closed, 2, 60, precision)) {
        ++rays;
        if (!convex) {
          Quad margin = 1;
          const int hits = hits_of(*closed.surface.shape.mesh, ray, margin);
          EXPECT_TRUE(hits % 2 == 1 || margin < kUndecided) << closed.name;
          continue;
        }
        EXPECT_TRUE(strictly_inside(closed.surface.shape, object_line<Quad>(closed.surface, ray).o)) << closed.name;
      }
    }
    EXPECT_GE(rays, 60 * 60);
  }
}

TEST(LeakRays, DependOnSeedAndNumberAlone) {
  const ClosedSurface closed = closed_meshes(PLUMB_DOUBLE)[1];
  const auto few = leak_rays(closed, 1, 10, PLUMB_DOUBLE), more = leak_rays(closed, 1, 20, PLUMB_DOUBLE);
  const auto other = leak_rays(closed, 2, 10, PLUMB_DOUBLE);
  ASSERT_EQ(more.size(), 20u);
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_EQ(few[i].direction, more[i].direction);
    EXPECT_NE(few[i].direction, other[i].direction);
  }
}

/// FNV-1a over the bits of the rays at each closed surface.
TEST(LeakRays, HaveTheSameBitsEverywhere) {
  const std::uint64_t golden[] = {0x2f26c6e23100210bu, 0x89efee56ab8ecd10u};
  for (const plumb_precision precision : kPrecisions) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    const auto add = [&](double x) {
      for (int byte = 0; byte < 8; ++byte) {
        hash = (hash ^ ((std::bit_cast<std::uint64_t>(x) >> (8 * byte)) & 0xff)) * 0x100000001b3u;
      }
    };
    for (const ClosedSurface& closed : all_closed(precision)) {
      for (const Ray& ray : leak_rays(closed, 1, 40, precision)) {
        for (int axis = 0; axis < 3; ++axis) add(ray.origin[axis]), add(ray.direction[axis]);
      }
    }
    EXPECT_EQ(hash, golden[precision == PLUMB_FLOAT ? 0 : 1]) << std::hex << "0x" << hash;
  }
}

/// In single precision, triangle by triangle: rays slip between neighbours.
TEST(LeakRays, SlipThroughPlainTriangles) {
  int rays = 0, leaks = 0, referee_leaks = 0;
  for (const ClosedSurface& closed : closed_meshes(PLUMB_FLOAT)) {
    const TriangleMesh& mesh = *closed.surface.shape.mesh;
    if (mesh.triangles.size() > 400) continue;
    for (const Ray& ray : leak_rays(closed, 3, 500, PLUMB_FLOAT)) {
      ++rays;
      bool hit = false, truly = false;
      for (const auto& [a, b, c] : mesh.triangles) {
        const std::array<Point3, 3> vertices{mesh.positions[a], mesh.positions[b], mesh.positions[c]};
        hit = hit || triangle<float>(vertices, line_of<float>(ray)).hit;
        truly = truly || triangle<Quad>(vertices, line_of<Quad>(ray)).hit;
      }
      leaks += hit ? 0 : 1;
      referee_leaks += truly ? 0 : 1;
    }
  }
  std::printf("%d of %d leak\n", leaks, rays);
  EXPECT_GT(rays, 5000);
  EXPECT_GT(leaks, rays / 100);
  EXPECT_EQ(referee_leaks, 0);
}

}  // namespace
}  // namespace plumb

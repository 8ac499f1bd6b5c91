#include <algorithm>
#include <array>

#include "meshes/generators/asked_size.h"
#include "meshes/generators/mesh_kind.h"
#include "meshes/generators/progress_steps.h"
#include "meshes/generators/random_bits.h"

namespace plumb {
namespace {

/// A district has the ground of a square with side 1 and 8 x 8 lanes in its middle, which are turned and lean together;
/// each holds one beam. Beams are within cylinders of radius kRadius around axes that are at least kLane cos(lean) =
/// 0.0474 apart, and no beam comes farther from the district's middle than 7/2 sqrt(2) kLane + kRadius / cos(lean) +
/// kLean kTall/2 = 0.47 < 1/2. So none meets another one.
constexpr std::uint32_t kLanes = 8;
constexpr double kLane = 0.05, kRadius = 0.0225, kLean = 0.33, kTall = 1.2;

struct District {
  Point3 middle;     ///< on the ground
  Vec3 row, column;  /// of unit length, in the ground
  Vec3 along;        ///< that of the beams, of unit length
};

/// A box around the axis from `foot` along `along`, turned about it by chance.
void add_beam(const Point3& foot, const Vec3& along, double length, double scale, RandomBits& random,
              TriangleMesh& mesh) {
  const Vec3 level = normalized(cross(along, {0, 0, 1}));
  const Vec3 other = cross(along, level);
  const Vec3 roll = random.heading();
  const Vec3 u = roll.x * level + roll.z * other, v = cross(along, u);
  // The halves of the two sides, legs of a right triangle: from a square to half as deep as wide.
  const double slim = random.between(0.45, 0.7);
  const double deep = kRadius * slim, wide = kRadius * std::sqrt(1 - slim * slim);

  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::uint32_t corner = 0; corner < 8; ++corner) {
    const Vec3 aside = (corner & 1 ? wide : -wide) * u + (corner & 2 ? deep : -deep) * v;
    const Point3 p = foot + aside + (corner & 4 ? length : 0.0) * along;
    mesh.positions.push_back({scale * p.x, scale * p.y, scale * p.z});
  }
  // (u, v, along) is right-handed: bits 0, 1 and 2 of a corner are x, y and z of a unit cube.
  constexpr std::array<std::array<std::uint32_t, 4>, 6> kSides{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (const auto& [a, b, c, d] : kSides) {
    mesh.triangles.push_back({first + a, first + b, first + c});
    mesh.triangles.push_back({first + a, first + c, first + d});
  }
}

District district(std::uint32_t row, std::uint32_t column, std::uint32_t across, RandomBits& random) {
  const Vec3 turned = random.heading();
  const Vec3 lean = kLean * random.in_ring(0.5);
  const double shift = across / 2.0 - 0.5;
  return {{column - shift, 0, row - shift}, turned, {-turned.z, 0, turned.x}, normalized(Vec3{lean.x, 1, lean.z})};
}

TriangleMesh make(const MeshRequest& request) {
  const std::uint64_t beams = (asked_triangles(request) + 11) / 12;
  constexpr std::uint64_t kEach = kLanes * kLanes;
  const std::uint32_t across = least_size((beams + kEach - 1) / kEach, 1, [](std::uint64_t n) { return n * n; });
  const double scale = 2.0 / across;
  TriangleMesh mesh;
  mesh.positions.reserve(8 * beams);
  mesh.triangles.reserve(12 * beams);
  ProgressSteps steps(request.progress, beams);
  for (std::uint64_t number = 0; number * kEach < beams; ++number) {
    RandomBits random(request.seed, number);
    const District here = district(static_cast<std::uint32_t>(number / across),
                                   static_cast<std::uint32_t>(number % across), across, random);
    for (std::uint64_t i = 0; i < kEach && mesh.triangles.size() < 12 * beams; ++i) {
      const double along_row = kLane * (static_cast<double>(i % kLanes) - 3.5);
      const double along_column = kLane * (static_cast<double>(i / kLanes) - 3.5);
      const double height = random.between(0.4, kTall);
      // Half way up the tallest beams' axes are above their places on the ground.
      const Vec3 to_top = (kTall / here.along.y) * here.along;
      const Point3 halfway = here.middle + along_row * here.row + along_column * here.column + Vec3{0, kTall / 2, 0};
      add_beam(halfway + -0.5 * to_top, here.along, height / here.along.y, scale, random, mesh);
      steps.step();
    }
  }
  return mesh;
}

}  // namespace

extern const MeshKind city_kind{
    "city", "Districts of long thin towers, 64 a district, which lean together and are turned each by itself.", true,
    true, make};

}  // namespace plumb

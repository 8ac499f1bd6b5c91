#include <algorithm>
#include <array>
#include <cmath>

#include "meshes/generators/asked_size.h"
#include "meshes/generators/mesh_kind.h"
#include "meshes/generators/progress_steps.h"
#include "meshes/generators/random_bits.h"

namespace plumb {
namespace {

/// The space of one needle: a long box around a chord of the unit cylinder. Needles stay within their own lane and so
/// apart from one another.
struct Lane {
  Point3 middle;
  Vec3 along, across;
  double half_length, half_width, half_height;
};

/// A tetrahedron with its tip at one end of the lane and a small triangle at the other one.
void add_needle(const Lane& lane, RandomBits& random, TriangleMesh& mesh) {
  const Vec3 up{0, 1, 0};
  const double girth = std::min({0.45 * lane.half_width, 0.45 * lane.half_height, lane.half_length / 50});
  const double sideways = 0.9 * lane.half_width - girth, upward = 0.9 * lane.half_height - girth;
  const Vec3 forward = random.coin() ? lane.along : -lane.along;
  const auto end = [&](double sign) {
    const double reach = sign * random.between(0.6, 1) * lane.half_length;
    const double aside = random.between(-sideways, sideways);
    const double above = random.between(-upward, upward);
    return lane.middle + reach * forward + aside * lane.across + above * up;
  };
  const Point3 base = end(-1), tip = end(1);

  // (u, v, forward) is right-handed, so the corners are counter-clockwise seen from the tip.
  const Vec3 u = up, v = cross(forward, up);
  const Vec3 roll = random.heading();
  const double height = std::sqrt(3.0) / 2;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const auto& [x, y] : std::array<std::array<double, 2>, 3>{{{1, 0}, {-0.5, height}, {-0.5, -height}}}) {
    const double along_u = girth * (x * roll.x - y * roll.z), along_v = girth * (x * roll.z + y * roll.x);
    mesh.positions.push_back(base + along_u * u + along_v * v);
  }
  mesh.positions.push_back(tip);
  for (const auto& [a, b, c] :
       std::array<std::array<std::uint32_t, 3>, 4>{{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}})
    mesh.triangles.push_back({first + a, first + b, first + c});
}

TriangleMesh make(const MeshRequest& request) {
  const std::uint64_t needles = (asked_triangles(request) + 3) / 4;
  const std::uint32_t layers = least_size(needles, 1, [](std::uint64_t n) { return n * n; });
  const auto lanes = static_cast<std::uint32_t>((needles + layers - 1) / layers);
  TriangleMesh mesh;
  mesh.positions.reserve(4 * needles);
  mesh.triangles.reserve(4 * needles);
  ProgressSteps steps(request.progress, needles);
  for (std::uint32_t layer = 0; layer < layers; ++layer) {
    RandomBits random(request.seed, layer);
    const Vec3 along = random.heading();
    const Vec3 across{along.z, 0, -along.x};
    const double y = (2.0 * layer + 1) / layers - 1;
    for (std::uint32_t i = 0; i < lanes && mesh.triangles.size() < 4 * needles; ++i) {
      const double offset = 0.9 * ((2.0 * i + 1) / lanes - 1);
      const Lane lane{Point3{0, y, 0} + offset * across, along,       across,
                      std::sqrt(1 - offset * offset),    0.9 / lanes, 1.0 / layers};
      add_needle(lane, random, mesh);
      steps.step();
    }
  }
  return mesh;
}

}  // namespace

extern const MeshKind needles_kind{
    "needles", "A pile of long thin needles, each a tetrahedron: layer upon layer, each in a direction of its own.",
    true, true, make};

}  // namespace plumb

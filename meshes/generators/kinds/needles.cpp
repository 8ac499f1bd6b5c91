#include <algorithm>
#include <array>
#include <cmath>

#include "meshes/generators/asked_size.h"
#include "meshes/generators/mesh_kind.h"
#include "meshes/generators/progress_steps.h"
#include "meshes/generators/random_bits.h"

namespace plumb {
namespace {

/// A bale is a cylinder of radius and half height 1 with so many layers of so many needles: few enough that the boxes
/// of only so many needles overlap, however many bales there are.
constexpr std::uint64_t kLayers = 16, kLanes = 16, kBale = kLayers * kLanes;

/// The space of one needle: a long box around a chord of the bale. Needles stay within their own lane and so
/// apart from one another.
struct Lane {
  Point3 middle;
  Vec3 along, across;
  double half_length, half_width, half_height;
};

/// A tetrahedron with its tip at one end of the lane and a small triangle at the other one.
void add_needle(const Lane& lane, RandomBits& random, TriangleMesh& mesh) {
  const Vec3 up{0, 1, 0};
  const double girth = std::min({0.45 * lane.half_width, 0.45 * lane.half_height, lane.half_length / 60});
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

/// Adds the first `count` needles of a bale around the origin.
void add_bale(std::uint64_t count, RandomBits& random, TriangleMesh& mesh) {
  Vec3 along;
  for (std::uint64_t i = 0; i < count; ++i) {
    if (i % kLanes == 0) along = random.heading();
    const Vec3 across{along.z, 0, -along.x};
    const double y = static_cast<double>(2 * (i / kLanes) + 1) / kLayers - 1;
    const double offset = 0.9 * (static_cast<double>(2 * (i % kLanes) + 1) / kLanes - 1);
    const Point3 middle = Point3{0, y, 0} + offset * across;
    add_needle({middle, along, across, std::sqrt(1 - offset * offset), 0.9 / kLanes, 1.0 / kLayers}, random, mesh);
  }
}

TriangleMesh make(const MeshRequest& request) {
  const std::uint64_t needles = (asked_triangles(request) + 3) / 4;
  const std::uint64_t bales = (needles + kBale - 1) / kBale;
  const std::uint32_t side = least_size(bales, 1, [](std::uint64_t n) { return n * n * n; });
  TriangleMesh mesh;
  mesh.positions.reserve(4 * needles);
  mesh.triangles.reserve(4 * needles);
  ProgressSteps steps(request.progress, bales);
  for (std::uint64_t bale = 0; bale < bales; ++bale) {
    RandomBits random(request.seed, bale);
    const std::size_t first = mesh.positions.size();
    add_bale(std::min(kBale, needles - bale * kBale), random, mesh);
    // Lanes end up to 1.06 from the bale's axis, and bales are 2 apart.
    const auto place = [&](double in_bale, std::uint64_t cell) {
      return (0.9 * in_bale + (2 * static_cast<double>(cell) + 1 - side)) / side;
    };
    for (std::size_t i = first; i < mesh.positions.size(); ++i) {
      Point3& p = mesh.positions[i];
      p = {place(p.x, bale % side), place(p.y, bale / side / side), place(p.z, bale / side % side)};
    }
    steps.step();
  }
  return mesh;
}

}  // namespace

extern const MeshKind needles_kind{
    "needles", "Bales of long thin needles, each a tetrahedron: layer upon layer, each in a direction of its own.",
    true, true, make};

}  // namespace plumb

#include "reference/exact_bounds.h"

#include <algorithm>
#include <cmath>

#include "reference/exact_bounds_domain.h"
#include "reference/exact_bounds_face.h"
#include "reference/exact_bounds_search.h"
#include "reference/stage_counters.h"

namespace plumb {
namespace {

constexpr std::int64_t kSaturated = std::int64_t{1} << 62;

/// The tightest box, by a function for the upper face along a row; a lower face is an upper one along the negative row.
template <class UpperFace>
Bounds3 tightest(const PlacedShape& placed, const UpperFace& upper_face) {
  require_bounded(placed);
  std::vector<Point3> vertices;
  if (placed.shape.kind == ShapeKind::mesh) {
    vertices = used_vertices(*placed.shape.mesh);
    if (vertices.empty()) return {};
  }
  Bounds3 box;
  for (int axis = 0; axis < 3; ++axis) {
    const Row& row = placed.world_from_object[static_cast<std::size_t>(axis)];
    const Row opposite{-row[0], -row[1], -row[2], -row[3]};
    // Adding zero turns -0 into 0.
    box.max[axis] = upper_face(placed.shape, vertices, row) + 0.0;
    box.min[axis] = -upper_face(placed.shape, vertices, opposite) + 0.0;
  }
  return box;
}

Bounds3 tightest_by_rationals(const PlacedShape& placed) {
  StageCounters counters;
  ++counters.rational;
  return tightest(placed, upper_face_by_rationals);
}

/// How many doubles `claimed` lies beyond `tight`, upwards.
std::int64_t doubles_beyond(double claimed, double tight) {
  if (std::isnan(claimed)) return -kSaturated;
  const std::int64_t a = double_rank(claimed), b = double_rank(tight);
  const std::uint64_t distance =
      static_cast<std::uint64_t>(std::max(a, b)) - static_cast<std::uint64_t>(std::min(a, b));
  const auto saturated = static_cast<std::int64_t>(std::min(distance, static_cast<std::uint64_t>(kSaturated)));
  return a >= b ? saturated : -saturated;
}

/// The largest magnitude among the coordinates and sides of a box.
double scale_of(const Bounds3& box) {
  double scale = 0;
  for (int axis = 0; axis < 3; ++axis)
    scale = std::max({scale, std::fabs(box.min[axis]), std::fabs(box.max[axis]), box.max[axis] - box.min[axis]});
  return scale;
}

bool has_nan(const Bounds3& box) {
  for (int axis = 0; axis < 3; ++axis)
    if (std::isnan(box.min[axis]) || std::isnan(box.max[axis])) return true;
  return false;
}

BoundsVerdict judge_around_nothing(const Bounds3& claimed) {
  BoundsVerdict verdict;
  verdict.contains = !has_nan(claimed);
  if (verdict.contains && claimed.empty()) return verdict;
  verdict.ulps_loose.fill(verdict.contains ? kSaturated : -kSaturated);
  verdict.relative_looseness = verdict.contains ? Bounds3::kInfinity : -Bounds3::kInfinity;
  return verdict;
}

/// The tightest box decides all: a face contains exactly if it is not inside of the tightest one.
BoundsVerdict judge(const Bounds3& tight, const Bounds3& claimed) {
  if (tight.empty()) return judge_around_nothing(claimed);
  BoundsVerdict verdict;
  const double scale = scale_of(tight);
  double deepest = 0, loosest = 0;
  const auto judge_face = [&](std::size_t face, double claim, double tightest) {
    const std::int64_t ulps = verdict.ulps_loose[face] = doubles_beyond(claim, tightest);
    if (ulps == 0) return;
    const double distance = std::fabs(claim - tightest) / scale;
    double& worst = ulps < 0 ? deepest : loosest;
    // What has no quotient (NaN or infinite claims, a scale of infinity) is infinitely far.
    worst = std::max(worst, std::isnan(distance) ? Bounds3::kInfinity : distance);
  };
  for (int axis = 0; axis < 3; ++axis) {
    const auto face = static_cast<std::size_t>(axis);
    judge_face(face, -claimed.min[axis], -tight.min[axis]);
    judge_face(face + 3, claimed.max[axis], tight.max[axis]);
  }
  verdict.contains = std::ranges::all_of(verdict.ulps_loose, [](std::int64_t ulps) { return ulps >= 0; });
  verdict.relative_looseness = deepest > 0 ? -deepest : loosest;
  return verdict;
}

}  // namespace

Bounds3 exact_bounds(const PlacedShape& placed) {
  StageCounters counters;
  bool filtered = true;
  const Bounds3 box = tightest(placed, [&](const Shape& shape, std::span<const Point3> vertices, const Row& row) {
    if (const auto face = upper_face_by_filter(shape, vertices, row)) return *face;
    filtered = false;
    return upper_face_by_polynomials(shape, vertices, row);
  });
  ++(filtered ? counters.filter : counters.expansion);
  return box;
}

BoundsVerdict judge_bounds(const PlacedShape& shape, const Bounds3& claimed) {
  return judge(exact_bounds(shape), claimed);
}

BoundsVerdict judge_bounds_rational(const PlacedShape& shape, const Bounds3& claimed) {
  return judge(tightest_by_rationals(shape), claimed);
}

}  // namespace plumb

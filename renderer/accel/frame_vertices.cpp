#include "renderer/accel/frame_vertices.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <span>
#include <vector>

#include "renderer/math/bounds3.h"

namespace plumb {
namespace {

/// So many vertices are worth another thread's while.
constexpr std::size_t kBlock = 8192;
constexpr double kLeastReach = 0x1p-20, kMostReach = 0x1p25;

bool is_finite(const Point3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

Bounds3 finite_bounds(std::span<const Point3> points) {
  Bounds3 bounds;
  for (const Point3& p : points) {
    if (!is_finite(p)) continue;
    for (int axis = 0; axis < 3; ++axis) {
      bounds.min[axis] = std::min(bounds.min[axis], p[axis]);
      bounds.max[axis] = std::max(bounds.max[axis], p[axis]);
    }
  }
  return bounds;
}

/// By blocks in order, so that which of two equal zeros remains does not depend on threads.
Bounds3 finite_bounds(std::span<const Point3> points, WorkerPool& pool) {
  std::vector<Bounds3> parts((points.size() + kBlock - 1) / kBlock);
  pool.blocks(points.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    parts[begin / kBlock] = finite_bounds(points.subspan(begin, end - begin));
  });
  Bounds3 bounds;
  for (const Bounds3& part : parts) bounds.extend(part);
  return bounds;
}

/// A vertex in the frame. Raises `error` to how far its rounding moved it on an axis; that of one that is not finite
/// counts for nothing.
BoxSide placed(const Point3& p, const FilterFrame& frame, double& error) {
  BoxSide vertex{};
  double most = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double moved = p[axis] - frame.center[axis];
    const double exact = moved * frame.factor;
    vertex[axis] = static_cast<float>(exact);
    // What the subtraction lost shows when it is undone.
    const double lost = std::fabs((frame.center[axis] + moved) - p[axis]) * frame.factor;
    const double off = std::fabs(static_cast<double>(vertex[axis]) - exact) + lost;
    if (off > most) most = off;  // not of NaN, whose triangles are left out
  }
  if (std::isfinite(most)) error = std::max(error, most);
  return vertex;
}

}  // namespace

FilterFrame frame_of(const TriangleMesh& mesh, WorkerPool& pool) {
  const Bounds3 bounds = finite_bounds(mesh.positions, pool);
  FilterFrame frame;
  if (bounds.empty()) return frame;
  const auto reach_from = [&](const Point3& center) {
    double reach = 0;
    for (int axis = 0; axis < 3; ++axis)
      reach = std::max({reach, std::fabs(bounds.min[axis] - center[axis]), std::fabs(bounds.max[axis] - center[axis])});
    return reach;
  };
  double reach = reach_from({});
  const Point3 middle = bounds.center();
  // Far from the origin, as in [1000, 1001]: the difference of such numbers needs fewer digits.
  if (reach > 16 * reach_from(middle) && reach < 0x1p100) {
    for (int axis = 0; axis < 3; ++axis) frame.center[axis] = static_cast<double>(static_cast<float>(middle[axis]));
    reach = reach_from(frame.center);
  }
  frame.is_usable = reach == 0 || (reach >= 0x1p-400 && reach <= 0x1p400);
  // Within these no product of weights, depths and the reciprocal of a direction overflows or is rounded below the
  // smallest float by more than the filters' slack.
  if (!(reach > kLeastReach && reach < kMostReach) && reach > 0 && frame.is_usable)
    frame.factor = std::scalbn(1.0, -std::ilogb(reach));
  frame.reach = std::max(reach * frame.factor, kLeastReach) * (1 + 0x1p-20);
  return frame;
}

FrameVertices::FrameVertices(const TriangleMesh& mesh, FilterFrame& frame, WorkerPool& pool)
    : vertices_(mesh.positions.size()) {
  std::atomic<double> error = 0;
  pool.blocks(mesh.positions.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    double largest = 0;
    for (std::size_t i = begin; i < end; ++i) vertices_[i] = placed(mesh.positions[i], frame, largest);
    for (double seen = error; seen < largest && !error.compare_exchange_weak(seen, largest);) {
    }
  });
  frame.vertex_error = error;
  if (error > 0 && frame.center != Point3{}) frame.vertex_error += 0x1p-52 * frame.reach;
}

}  // namespace plumb

#include "renderer/accel/bvh8.h"

#include <algorithm>

#include "renderer/accel/bvh8_walk.h"

namespace plumb {

Bvh8::Bvh8(std::shared_ptr<const TriangleMesh> mesh, const Bvh8Options& options)
    : searched_{std::move(mesh), {}}, walks_(bvh8_walks()) {
  searched_.tree = build_bvh8(*searched_.mesh, options);
  for (const Point3& p : searched_.mesh->positions)
    searched_.largest_coordinate = std::max(searched_.largest_coordinate, largest_coordinate(p));
  const FilterFrame& frame = searched_.tree.frame;
  const double farthest = 4.001 * frame.reach / frame.factor + largest_coordinate(frame.center);
  searched_.near_weight_error = any_weight_error(1.001 * (searched_.largest_coordinate + farthest), 0, 0);
}

std::size_t Bvh8::bytes() const { return searched_.tree.lines.bytes() + searched_.tree.triangles.bytes(); }

}  // namespace plumb

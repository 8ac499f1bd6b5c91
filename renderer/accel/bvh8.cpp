#include "renderer/accel/bvh8.h"

#include <algorithm>
#include <cmath>

#include "renderer/accel/bvh8_walk.h"

namespace plumb {

Bvh8::Bvh8(std::shared_ptr<const TriangleMesh> mesh, const Bvh8Options& options)
    : mesh_(std::move(mesh)), tree_(build_bvh8(*mesh_, options)) {
  for (const Point3& p : mesh_->positions)
    largest_coordinate_ =
        std::max(largest_coordinate_, std::max(std::fabs(p.x), std::max(std::fabs(p.y), std::fabs(p.z))));
}

std::optional<SurfaceHit> Bvh8::closest(const PlacedRay& ray, TraceCounters& counters) const {
  return closest_in_bvh8({tree_, *mesh_, largest_coordinate_}, ray, counters);
}

bool Bvh8::any(const PlacedRay& ray, TraceCounters& counters) const {
  return any_in_bvh8({tree_, *mesh_, largest_coordinate_}, ray, counters);
}

std::size_t Bvh8::bytes() const { return tree_.lines.bytes() + tree_.triangles.bytes(); }

}  // namespace plumb

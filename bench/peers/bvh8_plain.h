#pragma once

#include "bench/race/ray_sets.h"
#include "renderer/accel/bvh8_layout.h"

namespace plumb::bench {

/// The closest hit, and whether there is one, in the wide hierarchy with every triangle of a leaf tested by plain
/// Moller-Trumbore in doubles: what deciding exactly costs beside it.
Found plain_closest(const Bvh8Tree& tree, const Ray& ray);
bool plain_any(const Bvh8Tree& tree, const Ray& ray);

}  // namespace plumb::bench

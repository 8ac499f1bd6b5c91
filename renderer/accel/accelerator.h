#pragma once

#include <span>
#include <string_view>

#include "renderer/accel/hierarchy.h"

namespace plumb {

/// How what a ray may hit is found: by trying each, by a binary hierarchy, or, the triangles of meshes, by an 8-wide
/// one. All find the same hits.
enum class Accel { linear, bvh2, bvh8 };

/// The names that `--accel` takes, in the order of the enumeration.
std::span<const std::string_view> accel_names();

/// Numbered boxes, to be searched by rays: one by one or in the binary hierarchy, which is also what holds boxes where
/// meshes are in the 8-wide one.
class Accelerator {
 public:
  /// `origin_margin` as in Hierarchy.
  Accelerator(Accel accel, std::span<const Bounds3> bounds, double origin_margin = SlabTest::kMargin);

  /// As Hierarchy::walk; linear search visits every primitive whatever its box.
  template <class Visit>
  bool walk(const Ray& ray, TraceCounters& counters, Visit&& visit, double drift = 0) const {
    if (accel_ != Accel::linear) return hierarchy_.walk(ray, counters, visit, drift);
    for (std::uint32_t i = 0; i < count_; ++i)
      if (visit(i)) return true;
    return false;
  }

 private:
  Accel accel_;
  std::uint32_t count_;
  Hierarchy hierarchy_;
};

}  // namespace plumb

#pragma once

#include <span>
#include <string_view>

#include "renderer/accel/hierarchy.h"

namespace plumb {

/// How the surfaces that a ray may hit are found: by trying each, or by a hierarchy. Both find the same hits.
enum class Accel { linear, bvh2 };

/// The names that `--accel` takes, in the order of the enumeration.
std::span<const std::string_view> accel_names();

/// Numbered boxes, to be searched by rays.
class Accelerator {
 public:
  /// `origin_margin` as in Hierarchy.
  Accelerator(Accel accel, std::span<const Bounds3> bounds, double origin_margin = SlabTest::kMargin);

  /// As Hierarchy::walk; linear search visits every primitive whatever its box.
  template <class Visit>
  bool walk(const Ray& ray, TraceCounters& counters, Visit&& visit, double drift = 0) const {
    if (accel_ == Accel::bvh2) return hierarchy_.walk(ray, counters, visit, drift);
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

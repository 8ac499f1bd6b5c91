#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "renderer/accel/hierarchy.h"
#include "tools/kernels/kernel_table.h"

namespace plumb::kernels {

/// Tries every primitive.
class EveryPrimitive {
 public:
  EveryPrimitive(const std::vector<Bounds3>& bounds, double) : count_(static_cast<std::uint32_t>(bounds.size())) {}

  template <class Visit>
  void walk(const Ray&, Visit&& visit) const {
    for (std::uint32_t i = 0; i < count_; ++i)
      if (visit(i)) return;
  }

 private:
  std::uint32_t count_;
};

/// The renderer's hierarchy in doubles, for primitives whose own test errs by no more than `margin` of the coordinates
/// that take part. A handful of primitives is one leaf, whose box is not tested: what a kernel says of a single
/// primitive is the primitive's own test and nothing else.
class InHierarchy {
 public:
  InHierarchy(const std::vector<Bounds3>& bounds, double margin)
      : is_small_(bounds.size() <= kFew),
        few_(bounds, margin),
        hierarchy_(is_small_ ? std::vector<Bounds3>{} : all_widened(bounds, margin), margin) {}

  template <class Visit>
  void walk(const Ray& ray, Visit&& visit) const {
    if (is_small_) return few_.walk(ray, visit);
    TraceCounters counters;
    hierarchy_.walk(ray, counters, visit);
  }

 private:
  static constexpr std::size_t kFew = 8;
  static std::vector<Bounds3> all_widened(std::vector<Bounds3> bounds, double margin) {
    for (Bounds3& box : bounds) box = widened(box, margin);
    return bounds;
  }

  bool is_small_;
  EveryPrimitive few_;
  Hierarchy hierarchy_;
};

/// A kernel over primitives of one type:
///
///     struct Primitive {
///       static void collect(const plumb_surface&, std::uint32_t index, std::vector<Primitive>&);
///       struct PreparedRay { explicit PreparedRay(const Ray&); };
///       static constexpr double kMargin;  // how far its test errs, in parts of the coordinates
///       std::uint32_t surface, index;
///       Bounds3 bounds() const;
///       /// Calls report(t, u, v) for each hit within the ray's range, in rising order of t.
///       void intersect(const PreparedRay&, Report&&) const;
///     };
///
/// so that kernels which differ in the primitive's test differ in nothing else.
template <class Primitive, class Search = InHierarchy>
class PrimitiveKernel {
 public:
  explicit PrimitiveKernel(std::span<const plumb_surface> surfaces)
      : primitives_(collected(surfaces)), search_(boxes(primitives_), Primitive::kMargin) {}

  Hit closest(const Ray& ray) const {
    const typename Primitive::PreparedRay prepared(ray);
    Hit best;
    Ray rest = ray;
    search_.walk(rest, [&](std::uint32_t i) {
      visit_hits(i, prepared, [&](const Hit& hit) {
        if (!comes_before(hit, best)) return;
        best = hit;
        // A box may begin a rounding behind a hit that comes before it.
        rest.t_max = std::min(ray.t_max, hit.t + Primitive::kMargin * std::fabs(hit.t));
      });
      return false;
    });
    return best;
  }

  bool any(const Ray& ray) const {
    const typename Primitive::PreparedRay prepared(ray);
    bool found = false;
    search_.walk(ray, [&](std::uint32_t i) {
      visit_hits(i, prepared, [&](const Hit&) { found = true; });
      return found;
    });
    return found;
  }

  void all(const Ray& ray, std::vector<Hit>& hits) const {
    const typename Primitive::PreparedRay prepared(ray);
    search_.walk(ray, [&](std::uint32_t i) {
      visit_hits(i, prepared, [&](const Hit& hit) { hits.push_back(hit); });
      return false;
    });
  }

 private:
  static std::vector<Primitive> collected(std::span<const plumb_surface> surfaces) {
    std::vector<Primitive> primitives;
    for (std::size_t i = 0; i < surfaces.size(); ++i)
      Primitive::collect(surfaces[i], static_cast<std::uint32_t>(i), primitives);
    return primitives;
  }
  static std::vector<Bounds3> boxes(const std::vector<Primitive>& primitives) {
    std::vector<Bounds3> boxes;
    boxes.reserve(primitives.size());
    for (const Primitive& primitive : primitives) boxes.push_back(primitive.bounds());
    return boxes;
  }
  template <class Report>
  void visit_hits(std::uint32_t i, const typename Primitive::PreparedRay& prepared, Report&& report) const {
    const Primitive& primitive = primitives_[i];
    primitive.intersect(prepared, [&](double t, double u, double v) {
      report(Hit{primitive.surface, primitive.index, t, u, v});
    });
  }

  std::vector<Primitive> primitives_;
  Search search_;
};

}  // namespace plumb::kernels

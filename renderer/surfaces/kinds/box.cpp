#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "renderer/surfaces/surface.h"

namespace plumb {
namespace {

/// Faces are numbered 2 axis + (1 for the maximal one).
Normal3 face_normal(std::uint32_t face) {
  Normal3 normal;
  normal[static_cast<int>(face / 2)] = face % 2 == 1 ? 1 : -1;
  return normal;
}

class Box : public Surface {
 public:
  Box(const Point3& min, const Point3& max) : min_(min), max_(max) {}

  /// Rational slabs with closed sides: the entry if it lies in range, else the exit.
  std::optional<SurfaceHit> intersect(const Ray& ray, TraceCounters&) const override {
    SurfaceHit enter{.t = -std::numeric_limits<double>::infinity()};
    SurfaceHit leave{.t = std::numeric_limits<double>::infinity()};
    for (int axis = 0; axis < 3; ++axis) {
      const double o = ray.origin[axis];
      const double d = ray.direction[axis];
      if (d == 0) {
        if (!(o >= min_[axis] && o <= max_[axis])) return std::nullopt;
        continue;
      }
      const auto low_face = static_cast<std::uint32_t>(2 * axis);
      SurfaceHit near{.t = (min_[axis] - o) / d, .part = low_face};
      SurfaceHit far{.t = (max_[axis] - o) / d, .part = low_face + 1};
      if (d < 0) std::swap(near, far);
      if (!(near.t <= far.t)) return std::nullopt;  // NaN
      if (near.t > enter.t) enter = near;
      if (far.t < leave.t) leave = far;
    }
    if (!(enter.t <= leave.t)) return std::nullopt;
    if (ray.contains(enter.t)) return enter;
    if (ray.contains(leave.t)) return leave;
    return std::nullopt;
  }

  Normal3 normal(const Ray&, const SurfaceHit& hit) const override { return face_normal(hit.part); }

  Bounds3 world_bounds(const Transform& world_from_object) const override {
    return world_from_object(Bounds3{min_, max_});
  }

 private:
  Point3 min_;
  Point3 max_;
};

/// A box whose minPt lies beyond its maxPt on some axis has no inside. The course's renderer draws it all the
/// same, through the loop below, and some of its scenes show one; see docs/scene-format.md.
class InvertedBox : public Surface {
 public:
  InvertedBox(const Point3& min, const Point3& max) : min_(min), max_(max) {}

  std::optional<SurfaceHit> intersect(const Ray& ray, TraceCounters&) const override {
    if (!is_finite(ray.origin) || !is_finite(ray.direction) || !(ray.t_min <= ray.t_max)) return std::nullopt;
    double start = ray.t_min;
    double end = ray.t_max;
    std::uint32_t axis_of_start = 0;
    for (int axis = 0; axis < 3; ++axis) {
      double near = (min_[axis] - ray.origin[axis]) / ray.direction[axis];
      double far = (max_[axis] - ray.origin[axis]) / ray.direction[axis];
      if (ray.direction[axis] < 0) std::swap(near, far);
      if (start > far || near > end) return std::nullopt;
      if (near > start) {
        start = near;
        axis_of_start = static_cast<std::uint32_t>(axis);
      }
      end = std::min(end, far);
    }
    return SurfaceHit{.t = start, .part = 2 * axis_of_start};
  }

  /// Along the axis that gave the hit, turned against the ray.
  Normal3 normal(const Ray& ray, const SurfaceHit& hit) const override {
    const Normal3 along = face_normal(hit.part);
    return dot(along, ray.direction) > 0 ? -along : along;
  }

  Bounds3 world_bounds(const Transform& world_from_object) const override {
    Bounds3 box;
    box.extend(min_);
    box.extend(max_);
    return world_from_object(box);
  }

 private:
  Point3 min_;
  Point3 max_;
};

constexpr std::array kParameters{
    surface_shader_parameter,
    Parameter{.name = "minPt",
              .type = ValueType::point,
              .meaning = "the corner with the smallest coordinates",
              .presence = Presence::defaulted,
              .default_text = "0 0 0"},
    Parameter{.name = "maxPt",
              .type = ValueType::point,
              .meaning = "the corner with the largest coordinates",
              .presence = Presence::defaulted,
              .default_text = "0 0 0"},
};

std::unique_ptr<Surface> make(const ObjectDescription& object, SurfaceContext& context) {
  const Point3 min = object.point("minPt");
  const Point3 max = object.point("maxPt");
  for (int axis = 0; axis < 3; ++axis) {
    if (min[axis] <= max[axis]) continue;
    context.warnings.push_back(to_string(object.where("minPt")) + ": warning: minPt lies beyond maxPt in " +
                               "xyz"[axis] +
                               "; this inverted box is drawn as the course's renderer draws it, and no check uses it");
    return std::make_unique<InvertedBox>(min, max);
  }
  return std::make_unique<Box>(min, max);
}

}  // namespace

extern const SurfaceKind box_kind{{Role::surface, "Box", "A box with its edges along the axes.", kParameters}, make};

}  // namespace plumb

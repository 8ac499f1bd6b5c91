#include <array>
#include <cmath>

#include "renderer/math/support.h"
#include "renderer/surfaces/interval.h"
#include "renderer/surfaces/surface.h"

namespace plumb {
namespace {

class Cylinder : public Surface {
 public:
  Cylinder(const Point3& center, double radius, double height) : center_(center), radius_(radius), half_(height / 2) {}

  std::optional<SurfaceHit> intersect(const Ray& ray, TraceCounters&) const override {
    const std::optional<Interval> side = inside_radius(ray, center_, radius_, 2);
    const std::optional<Interval> slab = inside_slab(ray, center_.z, half_);
    if (!side || !slab) return std::nullopt;
    const std::optional<Interval> inside = intersection(*side, *slab);
    if (!inside) return std::nullopt;
    const std::optional<Crossing> crossing = first_crossing({{*inside}, 1}, ray);
    if (!crossing) return std::nullopt;
    return SurfaceHit{.t = crossing->t, .part = crossing->part};
  }

  Normal3 normal(const Ray& ray, const SurfaceHit& hit) const override {
    if (hit.part == kBottom) return {0, 0, -1};
    if (hit.part == kTop) return {0, 0, 1};
    const Vec3 out = ray.at(hit.t) - center_;
    return {out.x, out.y, 0};
  }

  /// The hull of the two end discs.
  Bounds3 world_bounds(const Transform& world_from_object) const override {
    return mapped_bounds(world_from_object.matrix(), [&](const AffineRow& row) {
      const double end = std::copysign(half_, row[2]);  // the one that lies higher
      return highest(row, RoundBody{.center = center_, .radius = radius_, .dimensions = 2, .shift = end});
    });
  }

 private:
  Point3 center_;
  double radius_;
  double half_;
};

constexpr std::array kParameters{
    surface_shader_parameter,
    Parameter{.name = "center",
              .type = ValueType::point,
              .meaning = "the middle of its axis, at half its height",
              .presence = Presence::defaulted,
              .default_text = "0 0 0"},
    Parameter{.name = "radius",
              .type = ValueType::number,
              .meaning = "its radius",
              .presence = Presence::defaulted,
              .default_text = "1",
              .range = Range::not_negative},
    Parameter{.name = "height",
              .type = ValueType::number,
              .meaning = "its height along z",
              .presence = Presence::defaulted,
              .default_text = "1",
              .range = Range::not_negative},
};

std::unique_ptr<Surface> make(const ObjectDescription& object, SurfaceContext&) {
  return std::make_unique<Cylinder>(object.point("center"), object.number("radius"), object.number("height"));
}

}  // namespace

extern const SurfaceKind cylinder_kind{
    {Role::surface, "Cylinder", "A cylinder around an axis along z, closed at both ends.", kParameters}, make};

}  // namespace plumb

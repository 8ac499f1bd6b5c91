#include <array>
#include <cmath>

#include "renderer/math/support.h"
#include "renderer/surfaces/interval.h"
#include "renderer/surfaces/surface.h"

namespace plumb {
namespace {

class Sphere : public Surface {
 public:
  Sphere(const Point3& center, double radius) : center_(center), radius_(radius) {}

  std::optional<SurfaceHit> intersect(const Ray& ray, TraceCounters&) const override {
    const std::optional<Interval> inside = inside_radius(ray, center_, radius_, 3);
    if (!inside) return std::nullopt;
    const std::optional<Crossing> crossing = first_crossing({{*inside}, 1}, ray);
    if (!crossing) return std::nullopt;
    return SurfaceHit{.t = crossing->t};
  }

  Normal3 normal(const Ray& ray, const SurfaceHit& hit) const override { return as_normal(ray.at(hit.t) - center_); }

  /// A transformed sphere reaches r |row i of the matrix| along axis i, less than its box's corners do.
  Bounds3 world_bounds(const Transform& world_from_object) const override {
    return mapped_bounds(world_from_object.matrix(), [&](const AffineRow& row) {
      return highest(row, RoundBody{.center = center_, .radius = radius_});
    });
  }

 private:
  Point3 center_;
  double radius_;
};

constexpr std::array kParameters{
    surface_shader_parameter,
    Parameter{.name = "center",
              .type = ValueType::point,
              .meaning = "its centre",
              .presence = Presence::defaulted,
              .default_text = "0 0 0"},
    Parameter{.name = "radius",
              .type = ValueType::number,
              .meaning = "its radius",
              .presence = Presence::defaulted,
              .default_text = "1",
              .range = Range::not_negative},
};

std::unique_ptr<Surface> make(const ObjectDescription& object, SurfaceContext&) {
  return std::make_unique<Sphere>(object.point("center"), object.number("radius"));
}

}  // namespace

extern const SurfaceKind sphere_kind{{Role::surface, "Sphere", "A sphere.", kParameters}, make};

}  // namespace plumb

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "renderer/math/support.h"
#include "renderer/surfaces/interval.h"
#include "renderer/surfaces/surface.h"

namespace plumb {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Where x^2 + y^2 <= slope^2 (z - tip)^2 and |z - center| <= half. With the tip inside the slab both nappes
/// show, and the solid is not convex: a line has up to four crossings.
class Cone : public Surface {
 public:
  Cone(const Point3& center, double tip_z, double radius, double height)
      : center_(center),
        tip_z_(tip_z),
        radius_(radius),
        slope_(radius / std::fabs(center.z - tip_z)),
        half_(height / 2) {}

  std::optional<SurfaceHit> intersect(const Ray& ray, TraceCounters&) const override {
    const std::optional<Interval> slab = inside_slab(ray, center_.z, half_);
    if (!slab) return std::nullopt;
    const Intervals side = inside_side(ray);
    Intervals inside;
    for (int i = 0; i < side.count; ++i) {
      if (const auto part = intersection(side.items[static_cast<std::size_t>(i)], *slab)) {
        inside.items[static_cast<std::size_t>(inside.count++)] = *part;
      }
    }
    const std::optional<Crossing> crossing = first_crossing(inside, ray);
    if (!crossing) return std::nullopt;
    return SurfaceHit{.t = crossing->t, .part = crossing->part};
  }

  /// Half the gradient of the side's equation. At the tip it vanishes, and the axis stands in.
  Normal3 normal(const Ray& ray, const SurfaceHit& hit) const override {
    if (hit.part == kBottom) return {0, 0, -1};
    if (hit.part == kTop) return {0, 0, 1};
    const Point3 p = ray.at(hit.t);
    const Normal3 out{p.x - center_.x, p.y - center_.y, -slope_ * slope_ * (p.z - tip_z_)};
    return out == Normal3{} ? Normal3{0, 0, 1} : out;
  }

  /// The hull of a cone, single or double, is that of its two end discs.
  Bounds3 world_bounds(const Transform& world_from_object) const override {
    const ExactSum from_tip = ExactSum(center_.z) - tip_z_;
    return mapped_bounds(world_from_object.matrix(), [&](const AffineRow& row) {
      const auto end = [&](double shift) {
        return highest(row, RoundBody{.center = center_,
                                      .radius = radius_,
                                      .dimensions = 2,
                                      .shift = shift,
                                      .numerator = from_tip + shift,
                                      .denominator = from_tip});
      };
      return std::max(end(-half_), end(half_));
    });
  }

 private:
  /// The intervals of a t^2 - 2 b t + c <= 0. Between the roots if a > 0, outside of them if a < 0.
  Intervals inside_side(const Ray& ray) const {
    const Vec3 f{ray.origin.x - center_.x, ray.origin.y - center_.y, slope_ * (ray.origin.z - tip_z_)};
    const Vec3 d{ray.direction.x, ray.direction.y, slope_ * ray.direction.z};
    const double a = d.x * d.x + d.y * d.y - d.z * d.z;
    const double b = f.z * d.z - f.x * d.x - f.y * d.y;
    const double c = f.x * f.x + f.y * f.y - f.z * f.z;
    // b^2 - a c, as products of 2x2 minors, so that the squares of far origins do not cancel.
    const double xz = f.x * d.z - f.z * d.x;
    const double yz = f.y * d.z - f.z * d.y;
    const double xy = f.x * d.y - f.y * d.x;
    const double discriminant = xz * xz + yz * yz - xy * xy;

    // Each coefficient is off by 12u of its terms at most, counting the slope's rounding; a minor is off by 8u |f| |d|,
    // and the discriminant by 64u of that times the largest minor.
    const double ff = dot(f, f), dd = dot(d, d);
    const double minors = std::fabs(xz) + std::fabs(yz) + std::fabs(xy) + 0x1p-46 * std::sqrt(ff * dd);
    const bool touches = std::fabs(discriminant) < 0x1p-46 * std::sqrt(ff * dd) * minors;
    const bool runs_along = std::fabs(a) < 0x1p-46 * dd;
    const bool starts_at_surface =
        std::fabs(c) < 0x1p-20 * ff && !(std::fabs(c) + 0x1p-49 * ff < ray.t_min * std::fabs(b));
    if (touches || runs_along || starts_at_surface) return exactly_inside_side(ray);
    if (!(discriminant >= 0)) return {};
    return inside_roots(a > 0, quadratic_roots(a, b, c, discriminant));
  }

  /// The same from coefficients without rounding, multiplied by the square of the tip's distance from the centre.
  Intervals exactly_inside_side(const Ray& ray) const {
    const ExactSum to_tip = ExactSum(center_.z) - tip_z_;
    const ExactSum scale = to_tip * to_tip;
    const ExactSum square = ExactSum().add_product(radius_, radius_);
    const ExactSum fx = ExactSum(ray.origin.x) - center_.x;
    const ExactSum fy = ExactSum(ray.origin.y) - center_.y;
    const ExactSum fz = ExactSum(ray.origin.z) - tip_z_;
    const auto& [dx, dy, dz] = ray.direction;
    const ExactSum a = scale * ExactSum().add_product(dx, dx).add_product(dy, dy) - square * dz * dz;
    const ExactSum b = square * fz * dz - scale * (fx * dx + fy * dy);
    const ExactSum c = scale * (fx * fx + fy * fy) - square * fz * fz;
    if (a.sign() == 0) return inside_linear(b, c);
    const std::optional<Roots> roots = quadratic_roots(a, b, c);
    if (!roots) return {};  // a > 0: a line steeper than the side always meets it
    return inside_roots(a.sign() > 0, *roots);
  }

  static Intervals inside_roots(bool between, const Roots& roots) {
    if (between) return {{Interval{{roots.first, kSide}, {roots.second, kSide}}}, 1};
    return {{Interval{{-kInfinity, kSide}, {roots.first, kSide}}, Interval{{roots.second, kSide}, {kInfinity, kSide}}},
            2};
  }

  /// c - 2 b t <= 0, for a line parallel to the side.
  static Intervals inside_linear(const ExactSum& b, const ExactSum& c) {
    if (b.sign() == 0) {
      if (c.sign() > 0) return {};
      return {{Interval{{-kInfinity, kSide}, {kInfinity, kSide}}}, 1};
    }
    const Crossing at{static_cast<double>(c.rounded() / (2 * b.rounded())), kSide};
    return {{b.sign() < 0 ? Interval{{-kInfinity, kSide}, at} : Interval{at, {kInfinity, kSide}}}, 1};
  }

  Point3 center_;
  double tip_z_;
  double radius_;
  double slope_;
  double half_;
};

constexpr std::array kParameters{
    surface_shader_parameter,
    Parameter{.name = "center",
              .type = ValueType::point,
              .meaning = "the middle of the part that is kept",
              .presence = Presence::defaulted,
              .default_text = "0 0 0"},
    Parameter{.name = "tipz",
              .type = ValueType::number,
              .meaning = "z of the tip; within the kept part it makes a double cone",
              .presence = Presence::defaulted,
              .default_text = "0"},
    Parameter{.name = "radius",
              .type = ValueType::number,
              .meaning = "radius at the height of the centre",
              .presence = Presence::defaulted,
              .default_text = "1",
              .range = Range::not_negative},
    Parameter{.name = "height",
              .type = ValueType::number,
              .meaning = "height of the kept part along z",
              .presence = Presence::defaulted,
              .default_text = "1",
              .range = Range::not_negative},
};

std::unique_ptr<Surface> make(const ObjectDescription& object, SurfaceContext&) {
  const Point3 center = object.point("center");
  const double tip_z = object.number("tipz");
  if (center.z == tip_z) {
    throw InputError(
        object.where("tipz"),
        "the cone's tip lies at the height of its centre, where its radius is measured; expected another tipz");
  }
  return std::make_unique<Cone>(center, tip_z, object.number("radius"), object.number("height"));
}

}  // namespace

extern const SurfaceKind cone_kind{
    {Role::surface, "Cone", "A truncated cone around an axis along z, closed at both ends.", kParameters}, make};

}  // namespace plumb

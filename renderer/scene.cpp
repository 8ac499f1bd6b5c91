#include "renderer/scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumb {
namespace {

/// How much larger than in object space an error may be in world space, relative to the coordinates there: taken to
/// object space, a coordinate is multiplied by at most the norm of the inverse, rounded at that size, and the error
/// multiplied by the norm of the matrix on the way back. `offset` is the same for the inverse's offset, absolute.
struct Amplification {
  double relative, offset;
};

Amplification amplification(const Transform& world_from_object) {
  double norm = 0, inverse_norm = 0, offset = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& m = world_from_object.matrix()[i];
    const auto& inverse = world_from_object.inverse_matrix()[i];
    norm = std::max(norm, std::fabs(m[0]) + std::fabs(m[1]) + std::fabs(m[2]));
    inverse_norm = std::max(inverse_norm, std::fabs(inverse[0]) + std::fabs(inverse[1]) + std::fabs(inverse[2]));
    offset = std::max(offset, std::fabs(inverse[3]));
  }
  // Past 2^60 nothing is left of the digits anyway, and infinite boxes would not sort.
  return {std::min(norm * inverse_norm, 0x1p60), std::min(norm * offset, 0x1p900)};
}

/// The boxes for the search: those of the surfaces, and room for the errors of rays in ill-conditioned frames.
std::vector<Bounds3> search_bounds(const std::vector<PlacedSurface>& placed) {
  std::vector<Bounds3> bounds;
  bounds.reserve(placed.size());
  for (const PlacedSurface& p : placed) {
    Bounds3 box = p.surface->world_bounds(p.world_from_object);
    if (!p.world_from_object.is_identity() && !box.empty()) {
      const auto [relative, offset] = amplification(p.world_from_object);
      const double wider = SlabTest::kMargin * offset;
      box = widened(box, SlabTest::kMargin * relative);
      box.min = box.min + Vec3{-wider, -wider, -wider};
      box.max = box.max + Vec3{wider, wider, wider};
    }
    bounds.push_back(box);
  }
  return bounds;
}

/// Twice the largest amplification: a ray's origin counts for itself and for the way from there to the box.
double origin_margin(const std::vector<PlacedSurface>& placed) {
  double largest = 0.5;
  for (const PlacedSurface& p : placed)
    if (!p.world_from_object.is_identity()) largest = std::max(largest, amplification(p.world_from_object).relative);
  return 2 * largest * SlabTest::kMargin;
}

/// Holds the nearest hit of several surfaces. Triangles are ordered among each other by their exact t, solids by the
/// double that they report, equal ones by the order of the surfaces; and the first triangle against the first solid by
/// the exact t rounded to nearest, which is monotone. So nothing depends on what is found first.
class ClosestSurface {
 public:
  ClosestSurface(const Ray& ray, const std::vector<PlacedSurface>& placed) : ray_(ray), placed_(placed) {}

  /// What lies strictly beyond is not nearer.
  double nearest() const {
    double t = Bounds3::kInfinity;
    if (triangle_) t = triangle_->hit.t + triangle_->hit.t_error;
    return solid_ ? std::min(t, solid_->hit.t) : t;
  }

  void offer(const Scene::Hit& hit) {
    if (vertices(hit)) {
      if (!triangle_ || is_nearer_triangle(hit, *triangle_)) triangle_ = hit;
    } else if (!solid_ || hit.hit.t < solid_->hit.t || (hit.hit.t == solid_->hit.t && hit.placed < solid_->placed)) {
      solid_ = hit;
    }
  }

  std::optional<Scene::Hit> found() const {
    if (!triangle_ || !solid_) return triangle_ ? triangle_ : solid_;
    const double solid_t = solid_->hit.t, t = triangle_->hit.t, error = triangle_->hit.t_error;
    if (t + error < solid_t) return triangle_;  // rounding is monotone, so what it leaves apart is apart
    if (t - error > solid_t) return solid_;
    const double nearest_t = exact(*triangle_).t();
    return nearest_t < solid_t || (nearest_t == solid_t && triangle_->placed < solid_->placed) ? triangle_ : solid_;
  }

 private:
  bool is_nearer_triangle(const Scene::Hit& a, const Scene::Hit& b) const {
    if (a.hit.t + a.hit.t_error < b.hit.t - b.hit.t_error) return true;
    if (a.hit.t - a.hit.t_error > b.hit.t + b.hit.t_error) return false;
    const int order = exact(a).compare_t(exact(b));
    return order < 0 || (order == 0 && a.placed < b.placed);
  }

  std::optional<TriangleVertices> vertices(const Scene::Hit& hit) const {
    return placed_[hit.placed].surface->triangle(hit.hit.part);
  }

  ExactTriangle exact(const Scene::Hit& hit) const {
    const Transform& transform = placed_[hit.placed].world_from_object;
    return {ray_, transform.is_identity() ? nullptr : &transform, vertices(hit).value()};
  }

  const Ray& ray_;
  const std::vector<PlacedSurface>& placed_;
  std::optional<Scene::Hit> triangle_, solid_;
};

}  // namespace

Scene::Scene(SceneContents contents, Accel accel)
    : contents_(std::move(contents)),
      accelerator_(accel, search_bounds(contents_.placed), origin_margin(contents_.placed)) {}

std::optional<Scene::Hit> Scene::closest_hit(const Ray& ray, TraceCounters& counters) const {
  ClosestSurface closest(ray, contents_.placed);
  Ray rest = ray;
  accelerator_.walk(rest, counters, [&](std::uint32_t index) {
    ++counters.primitive_tests;
    const PlacedSurface& placed = contents_.placed[index];
    PlacedRay placed_ray(ray, placed.world_from_object);
    placed_ray.nearest = closest.nearest();
    if (const auto hit = placed.surface->intersect_placed(placed_ray, counters)) closest.offer({*hit, index});
    rest.t_max = std::min(ray.t_max, closest.nearest());
    return false;
  });
  return closest.found();
}

bool Scene::blocks(const Ray& ray, TraceCounters& counters) const {
  return accelerator_.walk(ray, counters, [&](std::uint32_t index) {
    ++counters.primitive_tests;
    const PlacedSurface& placed = contents_.placed[index];
    return placed.surface->blocks_placed(PlacedRay(ray, placed.world_from_object), counters);
  });
}

ShadingPoint Scene::shading_point(const Ray& ray, const Hit& hit) const {
  const PlacedSurface& placed = contents_.placed[hit.placed];
  const Normal3 normal = placed.surface->normal(PlacedRay(ray, placed.world_from_object).object(), hit.hit);
  return {ray.at(hit.hit.t),
          normalized(placed.world_from_object.is_identity() ? normal : placed.world_from_object(normal)),
          normalized(-ray.direction)};
}

}  // namespace plumb

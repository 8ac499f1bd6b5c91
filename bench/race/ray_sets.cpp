#include "bench/race/ray_sets.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "bench/race/float_numbers.h"
#include "meshes/generators/random_bits.h"

namespace plumb::bench {
namespace {

/// Of RandomBits; each set is a part of it.
constexpr std::uint64_t kSeed = 20;
/// Where rays that leave a surface begin: far above the rounding of their origins (2^-24 of a coordinate), far below
/// what a picture shows.
constexpr double kOffset = 0x1p-12;

Vec3 on_unit_sphere(RandomBits& random) {
  for (;;) {
    const double x = random.between(-1, 1);
    const double y = random.between(-1, 1);
    const double z = random.between(-1, 1);
    const double square = x * x + y * y + z * z;
    if (square <= 1 && square > 0.01) return Vec3{x, y, z} / std::sqrt(square);
  }
}

/// The box's middle and diagonal, and what is placed around it.
struct Stage {
  explicit Stage(const TriangleMesh& mesh) {
    for (const auto& triangle : mesh.triangles)
      for (const std::uint32_t vertex : triangle) box.extend(mesh.positions[vertex]);
    middle = box.center();
    diagonal = length(box.max - box.min);
  }

  Point3 around(RandomBits& random) const { return as_floats(middle + diagonal * on_unit_sphere(random)); }

  Bounds3 box;
  Point3 middle;
  double diagonal;
};

Ray ray_at(const Point3& origin, const Point3& target) { return {origin, as_floats(normalized(target - origin))}; }

std::vector<Ray> primary(const Stage& stage, std::size_t count) {
  constexpr double kDistance = 1.25;
  const Vec3 forward = normalized(Vec3{-0.45, -0.35, -1});
  const Vec3 right = normalized(cross(forward, {0, 1, 0})), up = cross(right, forward);
  const Point3 eye = as_floats(stage.middle + (-kDistance * stage.diagonal) * forward);
  // The outline of a ball of radius r at the distance D is seen under the angle whose sine is r / D.
  const double sine = 0.3 / kDistance, half = sine / std::sqrt(1 - sine * sine);
  const auto width = static_cast<std::size_t>(std::sqrt(static_cast<double>(count)));
  const auto at = [&](std::size_t i) {
    return half * (2 * (static_cast<double>(i) + 0.5) / static_cast<double>(width) - 1);
  };
  std::vector<Ray> rays;
  for (std::size_t row = 0; row < width; ++row)
    for (std::size_t column = 0; column < width; ++column)
      rays.push_back({eye, as_floats(normalized(forward + at(column) * right - at(row) * up))});
  return rays;
}

std::vector<Ray> incoherent(const Stage& stage, std::size_t count, RandomBits random) {
  std::vector<Ray> rays;
  while (rays.size() < count) {
    const Point3 origin = stage.around(random);
    Point3 target;
    for (int axis = 0; axis < 3; ++axis) target[axis] = random.between(stage.box.min[axis], stage.box.max[axis]);
    rays.push_back(ray_at(origin, target));
  }
  return rays;
}

/// At points of edges or corners of random triangles.
std::vector<Ray> aimed(const Stage& stage, const TriangleMesh& mesh, std::size_t count, bool at_edges,
                       RandomBits random) {
  std::vector<Ray> rays;
  while (rays.size() < count) {
    const auto& triangle = mesh.triangles[random.bits() % mesh.triangles.size()];
    const std::size_t corner = random.bits() % 3;
    const Point3& a = mesh.positions[triangle[corner]];
    const Point3& b = mesh.positions[triangle[(corner + 1) % 3]];
    const Point3 target = at_edges ? as_floats(a + random.unit() * (b - a)) : a;
    rays.push_back(ray_at(stage.around(random), target));
  }
  return rays;
}

struct SeenPoint {
  Point3 point;
  Vec3 normal;  ///< of unit length, on the side that was seen
};

std::vector<SeenPoint> seen_points(const Stage& stage, const TriangleMesh& mesh, std::size_t count,
                                   const ClosestHit& closest) {
  std::vector<SeenPoint> seen;
  for (const Ray& ray : primary(stage, count)) {
    const Found found = closest(ray);
    if (!found.hit()) continue;
    const auto [a, b, c] = mesh.triangles[found.triangle];
    const auto& p = mesh.positions;
    const Vec3 normal = normalized(cross(p[b] - p[a], p[c] - p[a]));
    seen.push_back({as_floats(ray.at(found.t)), dot(normal, ray.direction) > 0 ? -normal : normal});
  }
  return seen;
}

/// `make` of the seen points in their order, each equally often.
template <class Make>
std::vector<Ray> from_seen(const std::vector<SeenPoint>& seen, std::size_t count, const Make& make) {
  std::vector<Ray> rays;
  if (seen.empty()) return rays;
  for (std::size_t i = 0; i < count; ++i) rays.push_back(make(seen[i * seen.size() / count]));
  return rays;
}

std::vector<Ray> diffuse(const Stage& stage, const std::vector<SeenPoint>& seen, std::size_t count, RandomBits random) {
  return from_seen(seen, count, [&](const SeenPoint& place) {
    // A normal of unit length plus a point of the unit sphere has the cosine's density. One that cancels has no
    // direction; the normal itself is as good.
    const Vec3 sum = place.normal + on_unit_sphere(random);
    const Vec3 direction = length(sum) > 1e-3 ? normalized(sum) : place.normal;
    return Ray{place.point, as_floats(direction), as_float(kOffset * stage.diagonal)};
  });
}

std::vector<Ray> shadow(const Stage& stage, const std::vector<SeenPoint>& seen, std::size_t count) {
  const Point3 light = as_floats(stage.middle + (1.5 * stage.diagonal) * normalized(Vec3{-0.5, 1, 0.6}));
  return from_seen(seen, count, [&](const SeenPoint& place) {
    return Ray{place.point, as_floats(light - place.point), kOffset, 1};
  });
}

FloatRay as_float_ray(const Ray& ray) {
  const auto f = [](double x) { return static_cast<float>(x); };
  return {{f(ray.origin.x), f(ray.origin.y), f(ray.origin.z)},
          f(ray.t_min),
          {f(ray.direction.x), f(ray.direction.y), f(ray.direction.z)},
          f(ray.t_max)};
}

constexpr std::array<std::string_view, 6> kNames{"primary", "incoherent", "diffuse", "shadow", "edge", "vertex"};

}  // namespace

std::vector<std::string_view> ray_set_names() { return {kNames.begin(), kNames.end()}; }

RaySet make_ray_set(std::string_view name, const TriangleMesh& mesh, std::size_t count, const ClosestHit& closest) {
  const Stage stage(mesh);
  RaySet set;
  set.name = name;
  if (name == "primary")
    set.rays = primary(stage, count);
  else if (name == "incoherent")
    set.rays = incoherent(stage, count, {kSeed, 1});
  else if (name == "diffuse")
    set.rays = diffuse(stage, seen_points(stage, mesh, count, closest), count, {kSeed, 2});
  else if (name == "shadow")
    set.rays = shadow(stage, seen_points(stage, mesh, count, closest), count);
  else if (name == "edge" || name == "vertex")
    set.rays = aimed(stage, mesh, count, name == "edge", {kSeed, name == "edge" ? 3u : 4u});
  else
    throw std::invalid_argument("no set of rays is called " + std::string(name));
  if (name == "shadow") set.question = Question::any;
  for (const Ray& ray : set.rays) set.floats.push_back(as_float_ray(ray));
  return set;
}

}  // namespace plumb::bench

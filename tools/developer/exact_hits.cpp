#include "tools/developer/exact_hits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

#include "conformance/checks/describe.h"
#include "conformance/families/closed_meshes.h"
#include "conformance/families/placed.h"
#include "renderer/math/input_error.h"
#include "renderer/surfaces/triangle.h"
#include "tools/developer/exact_scene.h"

namespace plumb {
namespace {

bool is_flat(const PlacedShape& placed) {
  return placed.shape.kind == ShapeKind::triangle || placed.shape.kind == ShapeKind::mesh;
}

/// The first crossings of several shapes: one, or several whose t the enclosures do not tell apart.
using Nearest = std::vector<ExactClosest::Entry>;

bool is_at(const ExactClosest::Entry& entry, const Scene::Hit& hit, bool flat) {
  return entry.shape == hit.placed && (!flat || entry.crossing.part == hit.hit.part);
}

/// Free crossings count for triangles. Equal doubles are ties, and go to the first.
Nearest nearest_of(std::span<const PlacedShape> shapes, const Ray& ray) {
  Nearest all;
  if (shapes.size() == 1) {
    const ExactHit hit = exact_hit(shapes[0], ray);
    if (!hit.crossings.empty()) all.push_back({0, hit.crossings.front()});
    return all;
  }
  const ExactClosest closest = exact_closest(shapes, ray);
  all = closest.free_nearer;
  all.insert(all.end(), closest.winners.begin(), closest.winners.end());
  if (all.empty()) return all;
  const auto key = [](const ExactClosest::Entry& e) {
    return std::tuple(e.crossing.t.below, e.crossing.t.above, e.shape, e.crossing.part);
  };
  std::ranges::sort(all, {}, key);
  if (all.front().crossing.t.exact()) {
    all.resize(1);
    return all;
  }
  const Enclosure first = all.front().crossing.t;
  std::erase_if(all, [&](const ExactClosest::Entry& e) { return !(e.crossing.t == first); });
  // Winners are in exact order. Where no free crossing is as near as they are, the first is the only right one.
  if (closest.free_nearer.empty()) all.assign(1, closest.winners.front());
  return all;
}

class Judge {
 public:
  Judge(std::span<const PlacedShape> shapes, Accel accel, ExactHits& tally)
      : shapes_(shapes), scene_(exact_scene(shapes, accel)), tally_(tally) {
    for (const PlacedShape& placed : shapes) {
      const bool is_mesh = placed.shape.kind == ShapeKind::mesh;
      triangles_.push_back(is_mesh ? static_cast<std::uint32_t>(placed.shape.mesh->triangles.size()) : 1);
    }
  }

  void judge(const Ray& ray, bool from_inside = false) {
    const ExactHit first_shape = exact_hit(shapes_[0], ray);
    if (first_shape.hit_class == HitClass::unsupported || first_shape.hit_class == HitClass::singular) {
      ++tally_.unsupported;
      return;
    }
    ++tally_.rays;
    const Nearest nearest = nearest_of(shapes_, ray);
    const bool flat = is_flat(shapes_[0]);
    const auto hit = scene_.closest_hit(ray, counters_);
    if (!nearest.empty()) {
      ++tally_.hits;
      tally_.boundary += nearest.front().crossing.free;
    }
    if (flat) judge_rounded(ray, nearest);
    // A program may leave out what a solid's line only touches, and report what lies behind.
    if (!flat && (first_shape.hit_class == HitClass::tangent || first_shape.hit_class == HitClass::boundary)) return;
    if (hit.has_value() != !nearest.empty()) {
      ++(from_inside ? tally_.escapes : tally_.wrong_class);
      note(ray, hit ? "a hit too many" : "a miss");
      return;
    }
    if (scene_.blocks(ray, counters_) != hit.has_value()) {
      ++tally_.wrong_class;
      note(ray, "blocks is wrong");
    }
    if (!hit || !flat) return;
    const auto right = std::ranges::find_if(nearest, [&](const auto& entry) { return is_at(entry, *hit, flat); });
    if (right == nearest.end()) {
      ++tally_.wrong_closest;
      note(ray, "triangle " + std::to_string(hit->hit.part) + " of " + std::to_string(hit->placed) + " instead of " +
                    std::to_string(nearest.front().crossing.part) + " of " + std::to_string(nearest.front().shape));
      return;
    }
    judge_t(ray, hit->hit, right->crossing);
    if (shapes_.size() == 1 && tally_.rays % 4 == 0) judge_range(ray, right->crossing.t);
  }

 private:
  /// By the ray of the triangles' own frame, rounded, and the smallest rounded t.
  std::optional<Scene::Hit> hit_if_rounded(const Ray& ray) const {
    std::optional<Scene::Hit> closest;
    for (std::uint32_t i = 0; i < scene_.placed().size(); ++i) {
      const Transform& transform = scene_.placed()[i].world_from_object;
      const Ray own = transform.is_identity() ? ray : transform.inverse_of(ray);
      const Surface& surface = *scene_.placed()[i].surface;
      for (std::uint32_t part = 0; part < triangles_[i]; ++part) {
        const auto [a, b, c] = *surface.triangle(part);
        const auto hit = intersect_triangle(ShearedRay(own), a, b, c);
        if (hit && (!closest || hit->t < closest->hit.t)) closest = Scene::Hit{{hit->t, hit->u, hit->v, part}, i};
      }
    }
    return closest;
  }

  void judge_rounded(const Ray& ray, const Nearest& nearest) {
    if (std::accumulate(triangles_.begin(), triangles_.end(), 0U) > 8) return;
    const auto hit = hit_if_rounded(ray);
    const bool right =
        hit ? std::ranges::any_of(nearest, [&](const auto& e) { return is_at(e, *hit, true); }) : nearest.empty();
    tally_.wrong_if_rounded += !right;
  }

  void judge_t(const Ray& ray, const SurfaceHit& hit, const ExactCrossing& crossing) {
    // The nearest double and the exact t are half a unit in the last place apart.
    const double error = std::fabs(hit.t - crossing.t_double);
    const double room = hit.t_error + (crossing.t.above - crossing.t.below);
    if (room > 0 && error > 0) tally_.largest_t_error = std::max(tally_.largest_t_error, error / room);
    if (error <= room && ray.contains(hit.t)) return;
    ++tally_.wrong_t;
    note(ray, "t is " + hex(hit.t));
  }

  void judge_range(const Ray& ray, const Enclosure& t) {
    const double bounds[] = {t.below, t.above};
    for (const double bound : bounds) {
      for (const bool is_end : {false, true}) {
        Ray part = ray;
        (is_end ? part.t_max : part.t_min) = bound;
        if (!(part.t_min <= part.t_max)) continue;
        ++tally_.range_questions;
        const Nearest nearest = nearest_of(shapes_, part);
        const auto hit = scene_.closest_hit(part, counters_);
        const bool right = hit.has_value() == !nearest.empty() &&
                           (!hit || (is_at(nearest.front(), *hit, true) && part.contains(hit->hit.t))) &&
                           scene_.blocks(part, counters_) == hit.has_value();
        if (right) continue;
        ++tally_.wrong_range;
        note(part, "wrong at a bound of the range");
      }
    }
  }

  void note(const Ray& ray, const std::string& what) {
    if (!tally_.first.empty()) return;
    tally_.first = what;
    for (const PlacedShape& shape : shapes_) tally_.first += "; " + oracle_command(shape, ray);
  }

  std::span<const PlacedShape> shapes_;
  std::vector<std::uint32_t> triangles_;
  Scene scene_;
  ExactHits& tally_;
  TraceCounters counters_;
};

void judge_all(const std::vector<PlacedShape>& shapes, const std::vector<Ray>& rays, Accel accel, ExactHits& tally,
               bool from_inside = false) {
  try {
    Judge judge(shapes, accel, tally);
    for (const Ray& ray : rays) judge.judge(ray, from_inside);
  } catch (const InputError&) {
    tally.unsupported += static_cast<std::int64_t>(rays.size());
  } catch (const SingularTransform&) {
    tally.unsupported += static_cast<std::int64_t>(rays.size());
  }
}

/// Axes that change places and sides, by powers of two, and a whole offset: few numbers are rounded under it, so that
/// rays at vertices meet them exactly.
AffineMatrix whole_placement(Random& random) {
  AffineMatrix matrix{};
  const std::uint32_t turn = random.below(3);
  for (std::uint32_t i = 0; i < 3; ++i) {
    matrix[i][(i + turn) % 3] = random.sign() * std::ldexp(1.0, random.integer(-10, 10));
    matrix[i][3] = random.whole(random.coin() ? 16 : 1e6);
  }
  return matrix;
}

/// A rotation, a scale of the condition, a rotation, each tenth without them; mirrored or not; an offset.
AffineMatrix random_placement(Random& random, const Rounding& rounded) {
  if (random.one_in(4)) return whole_placement(random);
  const auto rotation = [&] {
    const double x = random.between(-180, 180), y = random.between(-180, 180), z = random.between(-180, 180);
    return rotation_degrees({x, y, z});
  };
  const double condition = random.magnitude(1, 1e6);
  const double size = random.magnitude(1e-3, 1e3);
  Vec3 factors{size, size * std::sqrt(condition), size / std::sqrt(condition)};
  factors[random.integer(0, 2)] *= random.sign();
  AffineMatrix matrix = scaling(factors);
  if (!random.one_in(10)) {
    const AffineMatrix first = rotation();
    matrix = rotation() * matrix * first;
  }
  const double far = random.magnitude(1e-3, 1e6);
  for (auto& row : matrix) row[3] = far * random.between(-1, 1);
  return rounded(matrix);
}

/// The ray from the image of the origin to that of the place at t = 1, both rounded in world space.
Ray placed_ray(const Ray& ray, const AffineMatrix& matrix, const Rounding& rounded) {
  Ray placed = ray_to(rounded(mapped(matrix, ray.origin)), mapped(matrix, ray.at(1)), rounded);
  placed.t_min = ray.t_min;
  placed.t_max = ray.t_max;
  return placed;
}

std::vector<Ray> placed_rays_of(const std::vector<Ray>& rays, const AffineMatrix& matrix, const Rounding& rounded) {
  std::vector<Ray> result;
  for (const Ray& ray : rays) result.push_back(placed_ray(ray, matrix, rounded));
  return result;
}

std::string name_of(std::string_view what, plumb_precision precision, Placing placing) {
  return std::string(what) + (precision == PLUMB_FLOAT ? " float" : " double") +
         (placing == Placing::placed ? " placed" : "");
}

/// A triangle of nearly the same place as the first.
Vertices near_triangle(Random& random, const Vertices& first, const Rounding& rounded) {
  Vertices result = first;
  const int way = random.integer(0, 3);
  if (way == 0) std::rotate(result.begin(), result.begin() + random.integer(0, 2), result.end());
  if (way == 1) std::swap(result[0], result[1]);
  if (way == 2) {  // some coordinates one or two numbers further
    for (Point3& p : result)
      for (int axis = 0; axis < 3; ++axis)
        for (int steps = random.integer(0, 2); steps > 0; --steps)
          if (random.coin()) p[axis] = rounded.next(p[axis], random.sign() * std::numeric_limits<double>::infinity());
  }
  if (way == 3) {  // another of the plane, up to rounding
    const int corner = random.integer(0, 2);
    const double v = random.between(-0.5, 1.5), w = random.between(-0.5, 1.5);
    result[static_cast<std::size_t>(corner)] = rounded(weighted(first, v, w));
  }
  return result;
}

}  // namespace

ExactHits exact_hits_of(const FamilyKind& family, plumb_precision precision, Placing placing, Accel accel,
                        std::int64_t count) {
  ExactHits tally{.source = name_of(family.id, precision, placing)};
  const Rounding rounded(precision);
  const auto source = family.make(1, precision);
  for (std::uint64_t i = 0; tally.rays + tally.unsupported < count; ++i) {
    const FamilyCase one = source->next();
    PlacedShape shape{one.surface.shape, one.surface.world_from_object};
    std::vector<Ray> rays = one.rays;
    if (placing == Placing::placed) {
      if (!is_flat(shape) || shape.world_from_object != identity_matrix()) break;
      Random random(1, family.id, i);
      shape.world_from_object = random_placement(random, rounded);
      rays = placed_rays_of(rays, shape.world_from_object, rounded);
    }
    judge_all({shape}, rays, accel, tally);
  }
  return tally;
}

ExactHits exact_hits_in_closed_meshes(plumb_precision precision, Placing placing, Accel accel, std::int64_t count) {
  ExactHits tally{.source = name_of("closed meshes", precision, placing)};
  const Rounding rounded(precision);
  const std::vector<ClosedSurface> meshes = closed_meshes(precision);
  const auto each = static_cast<std::size_t>(count) / meshes.size() + 1;
  for (const ClosedSurface& closed : meshes) {
    const std::vector<Ray> rays = leak_rays(closed, 1, each, precision);
    if (placing == Placing::as_given) {
      judge_all({{closed.surface.shape, identity_matrix()}}, rays, accel, tally, true);
      continue;
    }
    // The image of an origin is rounded, and may lie outside. So an escape is told by the exact class.
    for (std::size_t begin = 0; begin < rays.size(); begin += 100) {
      Random random(1, closed.name, begin);
      const AffineMatrix matrix = random_placement(random, rounded);
      const std::vector<Ray> some(rays.begin() + static_cast<std::ptrdiff_t>(begin),
                                  rays.begin() + static_cast<std::ptrdiff_t>(std::min(begin + 100, rays.size())));
      judge_all({{closed.surface.shape, matrix}}, placed_rays_of(some, matrix, rounded), accel, tally);
    }
  }
  return tally;
}

ExactHits exact_hits_among_ties(plumb_precision precision, Placing placing, Accel accel, std::int64_t count) {
  ExactHits tally{.source = name_of("ties", precision, placing)};
  const Rounding rounded(precision);
  for (std::uint64_t i = 0; tally.rays + tally.unsupported < count; ++i) {
    Random random(1, "ties", i);
    std::vector<Vertices> triangles{ordinary_triangle(random, rounded)};
    const int copies = random.integer(1, 5);
    for (int k = 0; k < copies; ++k) triangles.push_back(near_triangle(random, triangles[0], rounded));
    std::vector<Ray> rays;
    while (rays.size() < 12) {
      const Point3 origin = facing_origin(random, triangles[0], 1, rounded);
      rays.push_back(ray_to(origin, any_point(random, triangles[0]), rounded));
    }
    const AffineMatrix matrix = placing == Placing::placed ? random_placement(random, rounded) : identity_matrix();
    if (placing == Placing::placed) rays = placed_rays_of(rays, matrix, rounded);
    std::vector<PlacedShape> shapes;
    if (i % 2 == 0) {
      TriangleMesh mesh;
      for (const Vertices& triangle : triangles) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), triangle.begin(), triangle.end());
        mesh.triangles.push_back({first, first + 1, first + 2});
      }
      shapes.push_back(
          {{.kind = ShapeKind::mesh, .mesh = std::make_shared<const TriangleMesh>(std::move(mesh))}, matrix});
    } else {
      for (const Vertices& triangle : triangles) {
        shapes.push_back({{.kind = ShapeKind::triangle, .vertices = triangle}, matrix});
        if (placing == Placing::as_given || random.coin()) continue;
        // The matrix doubled and the vertices halved: the same place.
        for (Point3& p : shapes.back().shape.vertices) p = {p.x / 2, p.y / 2, p.z / 2};
        for (auto& row : shapes.back().world_from_object)
          for (std::size_t column = 0; column < 3; ++column) row[column] *= 2;
      }
    }
    judge_all(shapes, rays, accel, tally);
  }
  return tally;
}

}  // namespace plumb

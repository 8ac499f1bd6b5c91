#include "reference/triangle_hit.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <vector>

#include "reference/triangle_crossing.h"

namespace plumb {
namespace {

using Corners = std::array<Point3, 3>;

/// Doubles first. What they leave open goes to expansions if the triangle is in world space, else to the polynomials,
/// which also give the numbers of a hit.
class FilteredTriangles {
 public:
  FilteredTriangles(const AffineMatrix& world_from_object, const Ray& ray, StageCounters& counters)
      : polynomial_(world_from_object, ray),
        identity_(world_from_object == identity_matrix()),
        mapped_(world_from_object, ray.origin),
        ray_(ray),
        counters_(counters) {}

  bool singular() const { return polynomial_.singular(); }

  std::optional<TriangleCrossing> crossing(const Point3& a, const Point3& b, const Point3& c) {
    if (identity_) {
      const HitClass decided = decide_triangle(ray_, a, b, c, counters_).hit_class;
      if (decided == HitClass::miss) return std::nullopt;
    } else {
      const TriangleEstimate estimate = estimate_triangle(mapped_(a, b, c), ray_.direction);
      const FilterVerdict verdict = judge_estimate(estimate, ray_.t_min, ray_.t_max);
      ++(verdict == FilterVerdict::undecided ? counters_.rational : counters_.filter);
      if (verdict == FilterVerdict::miss) return std::nullopt;
      if (verdict == FilterVerdict::undecided) return polynomial_.crossing(a, b, c);
    }
    // value() throws if the stages ever contradict each other.
    return polynomial_.crossing(a, b, c).value();
  }

 private:
  PolynomialTriangles polynomial_;
  bool identity_;
  MappedTriangles mapped_;
  Ray ray_;
  StageCounters& counters_;
};

std::size_t triangle_count(const Shape& shape) {
  if (shape.kind == ShapeKind::triangle) return 1;
  return shape.mesh ? shape.mesh->triangles.size() : 0;
}

Corners corners(const Shape& shape, std::size_t triangle) {
  if (shape.kind == ShapeKind::triangle) return shape.vertices;
  const auto [a, b, c] = shape.mesh->triangles[triangle];
  const std::vector<Point3>& positions = shape.mesh->positions;
  return {positions[a], positions[b], positions[c]};
}

bool is_valid(const Shape& shape) {
  const auto valid_corner = [&](std::uint32_t i) {
    return i < shape.mesh->positions.size() && is_finite(shape.mesh->positions[i]);
  };
  if (shape.kind == ShapeKind::triangle) return std::ranges::all_of(shape.vertices, is_finite<Point3>);
  return !shape.mesh || std::ranges::all_of(shape.mesh->triangles, [&](const auto& triangle) {
    return std::ranges::all_of(triangle, valid_corner);
  });
}

bool is_finite(const AffineMatrix& matrix) {
  return std::ranges::all_of(
      matrix, [](const auto& row) { return std::ranges::all_of(row, [](double x) { return std::isfinite(x); }); });
}

ExactCrossing rounded(const TriangleCrossing& crossing, std::size_t triangle) {
  const RoundedQuotient t = round_quotient(crossing.t);
  ExactCrossing result;
  result.t = t.enclosure;
  result.t_double = t.to_double;
  result.t_float = t.to_float;
  result.place = crossing.place;
  result.free = crossing.boundary;
  result.part = static_cast<std::uint32_t>(triangle);
  result.u = round_quotient(crossing.u).to_double;
  result.v = round_quotient(crossing.v).to_double;
  for (int i = 0; i < 3; ++i)
    result.position[i] = round_quotient(crossing.position[static_cast<std::size_t>(i)]).to_double;
  result.normal = round_direction(crossing.normal);
  return result;
}

struct Found {
  ExactCrossing crossing;
  Quotient t;
};

/// Enclosures tell two numbers apart unless they are the same pair of neighbours.
bool comes_before(const Found& a, const Found& b) {
  if (a.crossing.t != b.crossing.t)
    return std::pair(a.crossing.t.below, a.crossing.t.above) < std::pair(b.crossing.t.below, b.crossing.t.above);
  const int order = a.crossing.t.exact() ? 0 : compare(a.t, b.t);
  return order != 0 ? order < 0 : a.crossing.part < b.crossing.part;
}

template <class Triangles>
ExactHit hit_all(const Shape& shape, Triangles triangles) {
  ExactHit hit;
  if (triangles.singular()) {
    hit.hit_class = HitClass::singular;
    return hit;
  }
  std::vector<Found> found;
  for (std::size_t i = 0; i < triangle_count(shape); ++i) {
    const auto [a, b, c] = corners(shape, i);
    if (const auto crossing = triangles.crossing(a, b, c)) found.push_back({rounded(*crossing, i), crossing->t});
  }
  std::ranges::sort(found, comes_before);
  for (const Found& one : found) hit.crossings.push_back(one.crossing);
  if (!found.empty()) hit.hit_class = hit.crossings.front().free ? HitClass::boundary : HitClass::hit;
  return hit;
}

}  // namespace

ExactHit triangle_hit(const PlacedShape& shape, const Ray& ray, ExactPath path, StageCounters& counters) {
  const AffineMatrix& matrix = shape.world_from_object;
  if (!is_valid(ray) || !is_valid(shape.shape) || !is_finite(matrix)) {
    ExactHit hit;
    hit.hit_class = HitClass::unsupported;
    return hit;
  }
  switch (path) {
    case ExactPath::filtered:
      return hit_all(shape.shape, FilteredTriangles(matrix, ray, counters));
    case ExactPath::polynomial:
      return hit_all(shape.shape, PolynomialTriangles(matrix, ray));
    case ExactPath::rational:
      return hit_all(shape.shape, RationalTriangles(matrix, ray));
  }
  throw std::logic_error("no such path");
}

Quotient triangle_crossing_t(const PlacedShape& shape, const Ray& ray, const ExactCrossing& crossing) {
  const auto [a, b, c] = corners(shape.shape, crossing.part);
  return PolynomialTriangles(shape.world_from_object, ray).crossing(a, b, c).value().t;
}

}  // namespace plumb

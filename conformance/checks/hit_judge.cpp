#include "conformance/checks/hit_judge.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/exact_bounds.h"
#include "reference/triangle_oracle.h"

namespace plumb {
namespace {

constexpr double kBand = 16;
constexpr double kAnotherPlace = 0x1p20;

/// The size of the last place of a number rounded to the precision.
double last_place(double rounded, plumb_precision precision) {
  const int bits = precision == PLUMB_FLOAT ? 24 : 53;
  const int lowest = precision == PLUMB_FLOAT ? -149 : -1074;
  if (rounded == 0) return std::ldexp(1.0, lowest);
  return std::ldexp(1.0, std::max(std::ilogb(rounded) + 1 - bits, lowest));
}

bool is_flat(ShapeKind kind) { return kind == ShapeKind::triangle || kind == ShapeKind::mesh; }

double largest_distance(const PlacedShape& shape, const Point3& origin) {
  const Bounds3 box = exact_bounds(shape);
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    largest = std::max({largest, std::fabs(box.min[axis] - origin[axis]), std::fabs(box.max[axis] - origin[axis])});
  }
  return largest;
}

/// The solid larger (or, for a negative `by`, smaller) by a length on all sides; nothing where none is left. Triangles
/// stay.
std::optional<Shape> resized(Shape shape, double by) {
  shape.radius += by;
  shape.height += 2 * by;
  for (int axis = 0; axis < 3; ++axis) {
    shape.min[axis] -= by;
    shape.max[axis] += by;
    if (shape.kind == ShapeKind::box && shape.min[axis] > shape.max[axis]) return std::nullopt;
  }
  const bool is_round = shape.kind != ShapeKind::box && !is_flat(shape.kind);
  if (is_round && (shape.radius < 0 || shape.height < 0)) return std::nullopt;
  return shape;
}

/// The farthest that a point of the shape lies from the ray's origin, in object space, along an axis.
double object_distance(const PlacedShape& placed, const Ray& ray) {
  const Transform world_from_object(placed.world_from_object);
  return largest_distance({placed.shape}, world_from_object.inverse()(ray.origin));
}

bool is_identity(const AffineMatrix& matrix) { return matrix == identity_matrix(); }

}  // namespace

double unit_roundoff(plumb_precision precision) { return precision == PLUMB_FLOAT ? 0x1p-24 : 0x1p-53; }

double t_error_ulps(double t, const ExactCrossing& crossing, plumb_precision precision) {
  const double exact = precision == PLUMB_FLOAT ? static_cast<double>(crossing.t_float) : crossing.t_double;
  if (t == exact) return 0;
  return std::fabs(t - exact) / last_place(exact, precision);
}

bool is_distance(double t, const ExactCrossing& crossing, const PlacedShape& shape, const Ray& ray,
                 const Contract& contract) {
  const double slack = kAnotherPlace * unit_roundoff(contract.t_precision) * std::fabs(t);
  const auto near = [&](double other) { return std::fabs(t - other) <= slack; };
  if (near(crossing.t_double)) return false;
  if (near(crossing.t_double * length(ray.direction))) return true;
  if (is_identity(shape.world_from_object)) return false;
  return near(crossing.t_double * length(Transform(shape.world_from_object).inverse()(ray.direction)));
}

bool is_another_place(double t, const ExactCrossing& crossing, const PlacedShape& shape, const Ray& ray,
                      const Contract& contract) {
  const double off = std::fabs(t - crossing.t_double);
  const double unit = kAnotherPlace * unit_roundoff(contract.t_precision);
  // The box is asked for only where it can matter.
  if (off <= unit * std::fabs(crossing.t_double)) return false;
  const double reach = largest_distance(shape, ray.origin) / length(ray.direction);
  return !(off <= unit * (std::fabs(crossing.t_double) + reach));
}

std::vector<ExactCrossing> crossings_by_contract(const ExactHit& truth, const Ray& ray, ShapeKind kind,
                                                 const Contract& contract) {
  if (truth.inside && contract.inside == PLUMB_INSIDE_MISSES) return {};
  std::vector<ExactCrossing> counted;
  for (const ExactCrossing& crossing : truth.crossings) {
    if (contract.range == PLUMB_RANGE_OPEN && crossing.place != RangePlace::within) continue;
    // The cosine's sign is certain but for a plane that the ray grazes within the normal's rounding.
    const double toward = dot(crossing.normal, ray.direction);
    const bool grazing = std::fabs(toward) <= 0x1p-48 * length(ray.direction);
    if (is_flat(kind) && contract.culling == PLUMB_CULL_BACK && toward > 0 && !grazing) continue;
    counted.push_back(crossing);
    if (is_flat(kind) && contract.culling == PLUMB_CULL_BACK && grazing) counted.back().free = true;
  }
  return counted;
}

AnswerJudgement judge_answer(const ExactHit& truth, const Ray& ray, ShapeKind kind, const Contract& contract,
                             const SubjectHit& answer) {
  const std::vector<ExactCrossing> crossings = crossings_by_contract(truth, ray, kind, contract);
  const auto first_proper =
      static_cast<std::size_t>(std::ranges::find(crossings, false, &ExactCrossing::free) - crossings.begin());
  const bool may_miss = first_proper == crossings.size();

  AnswerJudgement judgement;
  judgement.free = !crossings.empty() && crossings.front().free;
  judgement.must_hit = truth.inside && !may_miss && std::isinf(ray.t_max);
  judgement.must_report = !truth.inside && !may_miss;
  if (!answer.hit()) {
    if (!may_miss) judgement.fault = AnswerFault::false_miss;
    return judgement;
  }
  if (crossings.empty()) {
    judgement.fault = AnswerFault::false_hit;
    return judgement;
  }
  const auto distance = [&](const ExactCrossing& c) { return std::fabs(c.t_double - answer.t); };
  const auto nearest = static_cast<std::size_t>(std::ranges::min_element(crossings, {}, distance) - crossings.begin());
  if (nearest > first_proper) {
    judgement.fault = AnswerFault::wrong_crossing;
    return judgement;
  }
  judgement.crossing = nearest;
  judgement.t_ulps = t_error_ulps(answer.t, crossings[nearest], contract.t_precision);
  return judgement;
}

bool within_rounding(const PlacedShape& shape, const Ray& ray, const Contract& contract, double condition,
                     const SubjectHit& answer) {
  const double u = unit_roundoff(contract.precision);
  if (shape.shape.kind == ShapeKind::triangle && is_identity(shape.world_from_object)) {
    condition = 1;
    const auto& [a, b, c] = shape.shape.vertices;
    if (edge_margin(ray, a, b, c, u) < kBand) return true;
  }
  const double by = kBand * u * condition;
  const auto right = [&](const ExactHit& truth, const Ray& moved) {
    const std::vector<ExactCrossing> crossings = crossings_by_contract(truth, moved, shape.shape.kind, contract);
    const auto first = std::ranges::find(crossings, false, &ExactCrossing::free);
    if (!answer.hit()) return first == crossings.end();
    if (first == crossings.end()) return !crossings.empty();
    // A thin piece is entered and left within rounding: either t means it.
    const double slack = 4 * by * (std::fabs(answer.t) + largest_distance(shape, ray.origin) / length(ray.direction));
    return std::fabs(first->t_double - answer.t) <= slack ||
           judge_answer(truth, moved, shape.shape.kind, contract, answer).fault == AnswerFault::none;
  };
  const ExactHit truth = exact_hit(shape, ray);
  const bool invented = crossings_by_contract(truth, ray, shape.shape.kind, contract).empty();
  if (right(truth, ray)) return true;
  const auto right_for_size = [&](double change) {
    const std::optional<Shape> shape_then = resized(shape.shape, change);
    const ExactHit truth_then = shape_then ? exact_hit({*shape_then, shape.world_from_object}, ray) : ExactHit{};
    // Where nothing is hit, it is the class that counts: which end of the sliver is meant does not.
    return right(truth_then, ray) || (invented && answer.hit() && !truth_then.crossings.empty());
  };
  if (!is_flat(shape.shape.kind)) {
    const double length_by = by * object_distance(shape, ray);
    if (right_for_size(length_by) || right_for_size(-length_by)) return true;
  }
  const double origin_by = by * largest_distance(shape, ray.origin);
  const double direction_by = by * length(ray.direction);
  const double t_by = origin_by / length(ray.direction);
  const auto right_for = [&](const Ray& moved) { return right(exact_hit(shape, moved), moved); };
  for (const double sign : {-1.0, 1.0}) {
    for (int axis = 0; axis < 3; ++axis) {
      Ray moved = ray;
      moved.origin[axis] += sign * origin_by;
      if (right_for(moved)) return true;
      moved = ray;
      moved.direction[axis] += sign * direction_by;
      if (right_for(moved)) return true;
    }
    Ray moved = ray;
    moved.t_min -= sign * (by * std::fabs(ray.t_min) + t_by);
    if (std::isfinite(ray.t_max)) moved.t_max += sign * (by * std::fabs(ray.t_max) + t_by);
    if (moved.t_min <= moved.t_max && right_for(moved)) return true;
  }
  return false;
}

}  // namespace plumb

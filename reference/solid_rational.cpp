#include "reference/solid_rational.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "reference/solid_rational_line.h"
#include "reference/solid_round.h"

namespace plumb {
namespace {

/// Where a t lies: the sign of each face's inequality, 1 strictly inside of it.
bool all_at_least(const std::vector<int>& signs, int least) {
  return std::all_of(signs.begin(), signs.end(), [&](int s) { return s >= least; });
}

std::uint32_t lowest_face(const std::vector<int>& signs) {
  return static_cast<std::uint32_t>(std::find(signs.begin(), signs.end(), 0) - signs.begin());
}

/// The point lies on both faces of one slab and strictly inside of everything else.
bool through_flat(const std::vector<int>& signs, bool box) {
  if (std::count(signs.begin(), signs.end(), 0) != 2) return false;
  const std::uint32_t first = lowest_face(signs);
  return first + 1 < signs.size() && signs[first + 1] == 0 && (first % 2 == (box ? 0U : 1U));
}

Rounded round_point(const RationalLine& line, const Event& t, const mpq_class& origin, const mpq_class& direction) {
  const mpq_class near = origin + direction * mpq_class(line.approximate(t));
  return round_exactly(double_near(near), [&](int scale, double x, double y) {
    const mpq_class target = (mpq_class(x) + mpq_class(y)) / scale;
    return line.sign(t, origin - target, direction);
  });
}

/// The coordinate j of n / |n|, n = at + t slope: against m by the sign of n_j^2 - m^2 |n|^2 at t, a polynomial.
double round_coordinate(const RationalLine& line, const Event& t, const WholeNormal& n, std::size_t j) {
  const int s = line.sign(t, mpq_class(n.at[j]), mpq_class(n.slope[j]));
  const mpf_class near(line.approximate(t));
  mpf_class square(0, kApproximationBits), component(0, kApproximationBits);
  mpz_class q0, q1, q2;
  for (std::size_t k = 0; k < 3; ++k) {
    const mpf_class x = mpf_class(n.at[k], kApproximationBits) + mpf_class(n.slope[k], kApproximationBits) * near;
    square += x * x;
    if (k == j) component = x;
    q0 += n.at[k] * n.at[k];
    q1 += 2 * n.at[k] * n.slope[k];
    q2 += n.slope[k] * n.slope[k];
  }
  const mpz_class& at = n.at[j];
  const mpz_class& slope = n.slope[j];
  const double guess = square > 0 ? mpf_class(component / sqrt(square)).get_d() : 0;
  return round_to_grid(guess, [&](double m) {
    const int sm = (m > 0) - (m < 0);
    if (s != sm) return s > sm ? 1 : -1;
    // m is a whole multiple of 2^-53.
    const mpz_class scaled(m * 0x1p53);
    const mpz_class m2 = scaled * scaled;
    return s * line.sign(t, ((at * at) << 106) - m2 * q0, ((2 * at * slope) << 106) - m2 * q1,
                         ((slope * slope) << 106) - m2 * q2);
  });
}

ExactCrossing describe(const RationalLine& line, const Ray& ray, const Event& t, std::uint32_t part) {
  ExactCrossing crossing;
  const Rounded rounded = round_point(line, t, 0, 1);
  crossing.t = rounded.enclosure;
  crossing.t_double = rounded.nearest;
  crossing.t_float = nearest_float(crossing.t);
  crossing.part = part;
  const WholeNormal normal = line.normal(t, part);
  for (int j = 0; j < 3; ++j) {
    crossing.position[j] = round_point(line, t, mpq_class(ray.origin[j]), mpq_class(ray.direction[j])).nearest;
    crossing.normal[j] = round_coordinate(line, t, normal, static_cast<std::size_t>(j));
  }
  return crossing;
}

/// A maximal run of events and gaps within the solid, by the indices of its first and last event.
struct Run {
  std::size_t first, last;
};

std::vector<Run> runs_within(const RationalLine& line, const std::vector<Event>& events) {
  std::vector<Run> runs;
  bool open = false;
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (all_at_least(line.faces_at(events[i]), 0)) {
      if (open) {
        runs.back().last = i;
      } else {
        runs.push_back({i, i});
      }
      open = i + 1 < events.size() && all_at_least(line.faces_between(events[i], events[i + 1]), 0);
    } else {
      open = false;
    }
  }
  return runs;
}

class RationalHit {
 public:
  RationalHit(const RationalLine& line, const PlacedShape& placed, const Ray& ray, std::vector<AlgebraicT>* roots)
      : line_(line), placed_(placed), ray_(ray), roots_(roots) {}

  ExactHit find() {
    const std::vector<Event> events = line_.events();
    for (const Run& run : runs_within(line_, events)) {
      const Event& first = events[run.first];
      if (run.first == run.last) {
        const std::vector<int> faces = line_.faces_at(first);
        const bool tangent = line_.double_root_at(first);
        add(first, tangent || !through_flat(faces, placed_.shape.kind == ShapeKind::box), tangent);
      } else {
        const bool free = !all_at_least(line_.faces_between(first, events[run.first + 1]), 1);
        add(first, free, false);
        add(events[run.last], free, false);
      }
    }
    hit_.inside = all_at_least(line_.faces_at(Event{}), 1);
    return hit_;
  }

 private:
  int compare(const Event& t, double limit) const {
    return std::isinf(limit) ? (limit > 0 ? -1 : 1) : line_.compare(t, mpq_class(limit));
  }

  void add(const Event& t, bool free, bool tangent) {
    const int from_min = compare(t, ray_.t_min);
    const int from_max = compare(t, ray_.t_max);
    if (from_min < 0 || from_max > 0) return;
    ExactCrossing crossing = describe(line_, ray_, t, lowest_face(line_.faces_at(t)));
    crossing.free = free;
    if (from_max == 0) crossing.place = RangePlace::at_max;
    if (from_min == 0) crossing.place = RangePlace::at_min;
    if (hit_.crossings.empty()) {
      hit_.hit_class = tangent ? HitClass::tangent : free ? HitClass::boundary : HitClass::hit;
    }
    hit_.crossings.push_back(crossing);
    if (roots_ != nullptr) roots_->push_back(line_.algebraic(t));
  }

  const RationalLine& line_;
  const PlacedShape& placed_;
  const Ray& ray_;
  std::vector<AlgebraicT>* roots_;
  ExactHit hit_;
};

}  // namespace

ExactHit rational_solid_hit(const PlacedShape& placed, const Ray& ray, std::vector<AlgebraicT>* roots) {
  RationalMatrix inverse;
  if (!invert(placed.world_from_object, inverse)) return {HitClass::singular, false, {}};
  const RationalLine line(placed, inverse, ray);
  return RationalHit(line, placed, ray, roots).find();
}

}  // namespace plumb

#include "reference/solid_filter.h"

#include <cmath>

#include "reference/solid_ball.h"
#include "reference/solid_line.h"
#include "reference/solid_round.h"
#include "reference/solid_spans.h"

namespace plumb {
namespace {

using BallLine = SolidLine<Ball>;

/// Answers 0 and remembers it where a ball does not decide: the caller then throws the whole answer away.
class BallAlgebra {
 public:
  using Line = BallLine;

  explicit BallAlgebra(const BallLine& line) : line_(line) {}

  const BallLine& line() const { return line_; }
  bool undecided() const { return undecided_; }

  int sign(const Ball& x) {
    const int s = sign_or_undecided(x);
    if (s != kUndecided) return s;
    undecided_ = true;
    return 0;
  }

  int compare(int x, int y) { return x == y ? 0 : sign(value(x) - value(y)); }

  const Ball& value(int root) {
    const auto i = static_cast<std::size_t>(root);
    if (!known_[i]) {
      if (root < kSmallerRoot) {
        values_[i] = -(line_.planes[i].at / line_.planes[i].slope);
        known_[i] = true;
      } else {
        find_side_roots();
      }
    }
    return values_[i];
  }

 private:
  /// q / a and c / q with q = -b - sign(b) root, where nothing cancels; either sign of b is right if it is in doubt.
  void find_side_roots() {
    known_[kSmallerRoot] = known_[kLargerRoot] = true;
    Ball& smaller = values_[kSmallerRoot];
    Ball& larger = values_[kLargerRoot];
    const Ball& a = line_.a;
    const int d = sign(line_.discriminant);
    if (sign(a) == 0) {
      smaller = larger = -(line_.c / (Ball(2) * line_.b));
    } else if (d == 0) {
      smaller = larger = -(line_.b / a);
    } else {
      const Ball s = sqrt(line_.discriminant);
      const bool downwards = line_.b.hi >= 0;
      const Ball q = downwards ? -(line_.b + s) : s - line_.b;
      smaller = q / a;
      larger = line_.c / q;
      if (downwards != (a.hi > 0)) std::swap(smaller, larger);
    }
  }

  const BallLine& line_;
  bool undecided_ = false;
  std::array<Ball, 8> values_;
  std::array<bool, 8> known_{};
};

/// Along the outward normal in world space: the transposed adjugate of the gradient or of the axis.
Three<Ball> normal_of(const BallLine& line, const SolidEnd& end, const Ball& t) {
  Three<Ball> object;
  const SolidLine<Ball>::Plane* face = nullptr;
  for (std::size_t i = 0; i < line.plane_count; ++i)
    if (line.planes[i].part == end.part) face = &line.planes[i];
  Three<Ball> world;
  if (face != nullptr) {
    const Ball outwards((end.part & 1) == (line.has_side ? 1U : 0U) ? -1.0 : 1.0);
    for (std::size_t j = 0; j < 3; ++j)
      world[j] = outwards * line.frame.adjugate[static_cast<std::size_t>(face->axis)][j];
    return world;
  }
  for (std::size_t i = 0; i < 3; ++i) object[i] = line.weight[i] * (line.from[i] + t * line.along[i]);
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < 3; ++i) world[j] = world[j] + line.frame.adjugate[i][j] * object[i];
  }
  return world;
}

bool round_normal(const Three<Ball>& n, Normal3& result) {
  const Ball length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  for (std::size_t j = 0; j < 3; ++j)
    if (!ball_to_grid(n[j] / length, result[static_cast<int>(j)])) return false;
  return true;
}

/// False if the ball leaves a rounding in doubt.
bool describe(const BallLine& line, const Ray& ray, const SolidEnd& end, const Ball& t, ExactCrossing& crossing) {
  Rounded rounded;
  if (!round_ball(t, rounded)) return false;
  crossing.t = rounded.enclosure;
  crossing.t_double = rounded.nearest;
  crossing.t_float = nearest_float(crossing.t);
  crossing.part = end.part;
  for (int j = 0; j < 3; ++j)
    if (!nearest_of_ball(Ball(ray.origin[j]) + t * Ball(ray.direction[j]), crossing.position[j])) return false;
  return round_normal(normal_of(line, end, t), crossing.normal);
}

class FilteredHit {
 public:
  FilteredHit(const BallLine& line, const Ray& ray) : line_(line), ray_(ray), algebra_(line) {}

  std::optional<ExactHit> find() {
    ExactHit hit;
    const SolidSpans spans = SpanFinder<BallAlgebra>(algebra_).find();
    for (std::size_t i = 0; i < spans.count && !algebra_.undecided(); ++i) {
      const SolidSpan& span = spans.items[i];
      if (!add(span, span.enter, hit) || (!span.single && !add(span, span.leave, hit))) return std::nullopt;
    }
    hit.inside = inside();
    if (algebra_.undecided()) return std::nullopt;
    return hit;
  }

 private:
  bool inside() {
    bool within = !line_.has_side || algebra_.sign(line_.c) < 0;
    for (std::size_t i = 0; i < line_.plane_count && within; ++i) within = algebra_.sign(line_.planes[i].at) > 0;
    return within;
  }

  int compare(const Ball& t, double limit) {
    return std::isinf(limit) ? (limit > 0 ? -1 : 1) : algebra_.sign(t - Ball(limit));
  }

  bool add(const SolidSpan& span, const SolidEnd& end, ExactHit& hit) {
    const Ball t = algebra_.value(end.root);
    const int from_min = compare(t, ray_.t_min);
    const int from_max = compare(t, ray_.t_max);
    if (from_min < 0 || from_max > 0) return true;
    ExactCrossing crossing;
    if (!describe(line_, ray_, end, t, crossing)) return false;
    add_crossing(span, from_min, from_max, crossing, hit);
    return true;
  }

  const BallLine& line_;
  const Ray& ray_;
  BallAlgebra algebra_;
};

}  // namespace

std::optional<ExactHit> filtered_solid_hit(const PlacedShape& placed, const Ray& ray) {
  SolidFrame<Ball> frame = solid_frame<Ball>(placed.world_from_object);
  const int det = sign_or_undecided(frame.det);
  if (det == kUndecided) return std::nullopt;
  if (det == 0) return ExactHit{HitClass::singular, false, {}};
  // A power of two is exact and brings the determinant near 1, which keeps the products of high degree in range.
  multiply(frame, Ball(std::ldexp(det, -std::ilogb(frame.det.hi))));
  const BallLine line = solid_line(placed, frame, ray);
  return FilteredHit(line, ray).find();
}

}  // namespace plumb

#include "reference/solid_polynomial.h"

#include <CGAL/Mpzf.h>

#include <cmath>

#include "reference/solid_ball.h"
#include "reference/solid_line.h"
#include "reference/solid_round.h"
#include "reference/solid_spans.h"

namespace plumb {
namespace {

using Integer = CGAL::Mpzf;  // times a power of two
using ExactLine = SolidLine<Integer>;

int sign_of(const Integer& x) { return static_cast<int>(CGAL::sign(x)); }

/// 106 bits of it. Both conversions of Mpzf::to_double are within a relative 2^-50, so the rest is measured.
Ball ball_of(const Integer& x) {
  const double first = x.to_double();
  if (!std::isfinite(first)) return {first, 0, std::numeric_limits<double>::quiet_NaN()};
  const Integer rest = x - Integer(first);
  const double second = rest.to_double();
  const double third = (rest - Integer(second)).to_double();
  const auto [hi, lo] = two_sum(first, second);
  const bool exact = rest == Integer(second);
  return {hi, lo, exact ? 0 : round_up(std::fabs(third)) * 2 + kUnderflow};
}

/// The sign of x + y sqrt(d), d >= 0.
int sign_with_root(const Integer& x, const Integer& y, const Integer& d) {
  const int sx = sign_of(x);
  const int sy = sign_of(y) * sign_of(d);
  if (sy == 0 || sx == sy) return sx;
  if (sx == 0) return sy;
  return sx * sign_of(x * x - y * y * d);
}

/// t = (rational + root sqrt(discriminant)) / denominator, where root is -1, 0 or 1 and the denominator positive.
struct ExactRoot {
  Integer rational;
  int root = 0;
  Integer denominator;
};

class PolynomialAlgebra {
 public:
  using Line = ExactLine;

  explicit PolynomialAlgebra(const ExactLine& line) : line_(line) {}

  const ExactLine& line() const { return line_; }
  int sign(const Integer& x) const { return sign_of(x); }

  ExactRoot value(int root) const {
    if (root < kSmallerRoot) {
      const auto& plane = line_.planes[static_cast<std::size_t>(root)];
      return over(-plane.at, plane.slope, 0);
    }
    const int a = sign_of(line_.a);
    if (a == 0) return over(-line_.c, Integer(2) * line_.b, 0);
    const int upper = root == kLargerRoot ? 1 : -1;
    return over(-line_.b, line_.a, sign_of(line_.discriminant) == 0 ? 0 : upper * a);
  }

  /// The sign of t - p / q, q > 0.
  int compare(const ExactRoot& t, const Integer& p, const Integer& q) const {
    const Integer x = t.rational * q - p * t.denominator;
    return t.root == 0 ? sign_of(x) : sign_with_root(x, t.root > 0 ? q : Integer(-q), line_.discriminant);
  }

  /// Only the side has irrational roots, so at least one of two different ones is rational.
  int compare(int x, int y) const {
    if (x == y) return 0;
    if (x >= kSmallerRoot && y >= kSmallerRoot) return x < y ? -1 : 1;
    if (y >= kSmallerRoot) return -compare(y, x);
    const ExactRoot other = value(y);
    return compare(value(x), other.rational, other.denominator);
  }

 private:
  static ExactRoot over(const Integer& numerator, const Integer& denominator, int root) {
    if (sign_of(denominator) > 0) return {numerator, root, denominator};
    return {-numerator, -root, -denominator};
  }

  const ExactLine& line_;
};

/// A vector of numbers x + y sqrt(discriminant).
struct RootVector {
  Three<Integer> x, y;
};

/// Rounds what is known exactly of one crossing.
class ExactDescription {
 public:
  ExactDescription(const PlacedShape& placed, const PolynomialAlgebra& algebra, const Ray& ray, SolidRounding rounding)
      : placed_(placed), algebra_(algebra), line_(algebra.line()), ray_(ray), rounding_(rounding) {}

  ExactCrossing describe(const SolidEnd& end) {
    t_ = algebra_.value(end.root);
    root_ = t_.root == 0 ? Ball() : sqrt(ball_of(line_.discriminant));
    t_ball_ = ball_of_t(end.root);
    ExactCrossing crossing;
    const Rounded t = round_point(0, 1);
    crossing.t = t.enclosure;
    crossing.t_double = t.nearest;
    crossing.t_float = nearest_float(crossing.t);
    crossing.part = end.part;
    for (int j = 0; j < 3; ++j) crossing.position[j] = round_point(ray_.origin[j], ray_.direction[j]).nearest;
    crossing.normal = round_normal(normal_of(end.part));
    return crossing;
  }

 private:
  /// Where the two terms cancel, c over a times the other root.
  Ball ball_of_t(int root) const {
    const Ball rational = ball_of(t_.rational);
    const Ball denominator = ball_of(t_.denominator);
    if (t_.root == 0) return rational / denominator;
    const bool cancels = (rational.hi > 0) != (t_.root > 0) && root >= kSmallerRoot;
    const Ball sum = (t_.root > 0) != cancels ? rational + root_ : rational - root_;
    if (!cancels) return sum / denominator;
    const Ball c = ball_of(line_.c);
    return (sign_of(line_.a) > 0 ? c : -c) / sum;
  }

  /// origin + t direction.
  Rounded round_point(double origin, double direction) const {
    const Ball ball = Ball(origin) + t_ball_ * Ball(direction);
    Rounded rounded;
    if (rounding_ == SolidRounding::balls_first && round_ball(ball, rounded)) return rounded;
    const Integer o(origin);
    const Integer d(std::fabs(direction));
    const int sign = direction < 0 ? -1 : 1;
    return round_exactly(ball.hi, [&](int scale, double x, double y) {
      // scale (o + t d) - (x + y), over |d| scale.
      const Integer offset = Integer(x) + Integer(y) - Integer(scale) * o;
      if (direction == 0) return -sign_of(offset);
      return sign * algebra_.compare(t_, sign > 0 ? offset : Integer(-offset), Integer(scale) * d);
    });
  }

  /// Times denominator and det: the transposed adjugate of the gradient of the side at from + t along, or of the axis.
  RootVector normal_of(std::uint32_t part) const {
    const auto& adjugate = line_.frame.adjugate;
    for (std::size_t i = 0; i < line_.plane_count; ++i) {
      if (line_.planes[i].part != part) continue;
      const bool lower = i % 2 == 0;
      return along_axis(static_cast<std::size_t>(line_.planes[i].axis), lower ? -1 : 1);
    }
    RootVector n;
    for (std::size_t i = 0; i < 3; ++i) {
      const Integer x = line_.weight[i] * (line_.from[i] * t_.denominator + line_.along[i] * t_.rational);
      const Integer y = Integer(t_.root) * line_.weight[i] * line_.along[i];
      for (std::size_t j = 0; j < 3; ++j) {
        n.x[j] = n.x[j] + adjugate[i][j] * x;
        n.y[j] = n.y[j] + adjugate[i][j] * y;
      }
    }
    for (std::size_t j = 0; j < 3; ++j)
      if (sign_with_root(n.x[j], n.y[j], line_.discriminant) != 0) return n;
    const bool downwards = placed_.shape.kind == ShapeKind::cone && placed_.shape.tip_z < placed_.shape.center.z;
    return along_axis(2, downwards ? -1 : 1);
  }

  RootVector along_axis(std::size_t axis, int sign) const {
    RootVector n;
    for (std::size_t j = 0; j < 3; ++j) n.x[j] = Integer(sign) * line_.frame.adjugate[axis][j];
    return n;
  }

  Normal3 round_normal(const RootVector& n) const {
    Three<Ball> balls;
    Ball square;
    for (std::size_t j = 0; j < 3; ++j) {
      balls[j] = ball_of(n.x[j]) + ball_of(n.y[j]) * root_;
      square = square + balls[j] * balls[j];
    }
    const Ball length = sqrt(square);
    Normal3 rounded;
    for (std::size_t j = 0; j < 3; ++j) {
      const Ball ball = balls[j] / length;
      double& result = rounded[static_cast<int>(j)];
      if (rounding_ == SolidRounding::exact || !ball_to_grid(ball, result))
        result = round_exactly_to_grid(n, j, ball.hi);
    }
    return rounded;
  }

  /// n_j / |n| against m: by the signs, then n_j^2 against m^2 |n|^2.
  double round_exactly_to_grid(const RootVector& n, std::size_t j, double guess) const {
    const Integer& d = line_.discriminant;
    const int s = sign_with_root(n.x[j], n.y[j], d);
    const auto rational_square = [&](std::size_t k) { return n.x[k] * n.x[k] + n.y[k] * n.y[k] * d; };
    const auto root_square = [&](std::size_t k) { return Integer(2) * n.x[k] * n.y[k]; };
    const Integer x = rational_square(0) + rational_square(1) + rational_square(2);
    const Integer y = root_square(0) + root_square(1) + root_square(2);
    const Integer xj = rational_square(j);
    const Integer yj = root_square(j);
    return round_to_grid(guess, [&](double m) {
      const int sm = (m > 0) - (m < 0);
      if (s != sm) return s > sm ? 1 : -1;
      const Integer square = Integer(m) * Integer(m);
      return s * sign_with_root(xj - square * x, yj - square * y, d);
    });
  }

  const PlacedShape& placed_;
  const PolynomialAlgebra& algebra_;
  const ExactLine& line_;
  const Ray& ray_;
  SolidRounding rounding_;
  ExactRoot t_;
  Ball root_, t_ball_;
};

int compare(const PolynomialAlgebra& algebra, int root, double limit) {
  if (std::isinf(limit)) return limit > 0 ? -1 : 1;
  return algebra.compare(algebra.value(root), Integer(limit), Integer(1));
}

}  // namespace

ExactHit polynomial_solid_hit(const PlacedShape& placed, const Ray& ray, SolidRounding rounding) {
  SolidFrame<Integer> frame = solid_frame<Integer>(placed.world_from_object);
  const int det = sign_of(frame.det);
  if (det == 0) return {HitClass::singular, false, {}};
  // A determinant near 1 keeps the balls in range; beyond the range of doubles they decide nothing, which is no harm.
  const double size = std::fabs(frame.det.to_double());
  const bool in_range = size > 0x1p-1000 && size < 0x1p1000;
  multiply(frame, Integer(std::ldexp(det, in_range ? -std::ilogb(size) : 0)));

  const ExactLine line = solid_line(placed, frame, ray);
  PolynomialAlgebra algebra(line);
  ExactDescription description(placed, algebra, ray, rounding);
  const SolidSpans spans = SpanFinder<PolynomialAlgebra>(algebra).find();
  ExactHit hit;
  for (std::size_t i = 0; i < spans.count; ++i) {
    const SolidSpan& span = spans.items[i];
    for (const SolidEnd* end : {&span.enter, &span.leave}) {
      const int from_min = compare(algebra, end->root, ray.t_min);
      const int from_max = compare(algebra, end->root, ray.t_max);
      if (from_min >= 0 && from_max <= 0) {
        add_crossing(span, from_min, from_max, description.describe(*end), hit);
      }
      if (span.single) break;
    }
  }
  hit.inside = !line.has_side || sign_of(line.c) < 0;
  for (std::size_t i = 0; i < line.plane_count; ++i) hit.inside = hit.inside && sign_of(line.planes[i].at) > 0;
  return hit;
}

}  // namespace plumb

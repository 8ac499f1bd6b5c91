#include "reference/explain.h"

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "reference/exact_bounds.h"

namespace plumb {
namespace {

using Rational = mpq_class;
using RationalVector = std::array<Rational, 3>;

constexpr int kDigits = 30;
/// Enough for 30 digits of a difference in which 300 bits cancel.
constexpr unsigned kBits = 512;

Rational exact(double value) {
  if (!std::isfinite(value)) throw std::invalid_argument("a number is not finite");
  return Rational(value);
}

std::string decimal(const mpf_class& value) {
  mp_exp_t exponent = 0;
  std::string digits = value.get_str(exponent, 10, kDigits);
  if (digits.empty()) return "0";
  const bool negative = digits.front() == '-';
  if (negative) digits.erase(0, 1);
  std::string text = negative ? "-" : "";
  if (exponent > 0 && exponent <= 21) {
    const auto whole = static_cast<std::size_t>(exponent);
    if (digits.size() < whole) digits.append(whole - digits.size(), '0');
    text += digits.substr(0, whole);
    return digits.size() > whole ? text + "." + digits.substr(whole) : text;
  }
  if (exponent <= 0 && exponent > -5)
    return text + "0." + std::string(static_cast<std::size_t>(-exponent), '0') + digits;
  text += digits.substr(0, 1);
  if (digits.size() > 1) text += "." + digits.substr(1);
  return text + "e" + std::to_string(exponent - 1);
}

mpf_class to_float(const Rational& value) { return mpf_class(value, kBits); }

ExplainedNumber number(std::string name, std::string formula, const Rational& value) {
  return {std::move(name), std::move(formula), value.get_str(), decimal(to_float(value)), sgn(value)};
}

Rational dot(const RationalVector& a, const RationalVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

RationalVector cross(const RationalVector& a, const RationalVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class Triple>
RationalVector vector(const Triple& v) {
  return {exact(v.x), exact(v.y), exact(v.z)};
}

RationalVector minus(const RationalVector& a, const RationalVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// The ray in the shape's own frame, by Cramer's rule.
struct ObjectRay {
  RationalVector origin, direction;
};

ObjectRay object_ray(const AffineMatrix& matrix, const Ray& ray) {
  std::array<RationalVector, 3> column;
  RationalVector offset;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) column[j][i] = exact(matrix[i][j]);
    offset[i] = exact(matrix[i][3]);
  }
  const Rational determinant = dot(column[0], cross(column[1], column[2]));
  if (determinant == 0) throw std::invalid_argument("the matrix has no inverse: its determinant is exactly 0");
  const auto solve = [&](const RationalVector& right) -> RationalVector {
    return {dot(right, cross(column[1], column[2])) / determinant,
            dot(column[0], cross(right, column[2])) / determinant,
            dot(column[0], cross(column[1], right)) / determinant};
  };
  return {solve(minus(vector(ray.origin), offset)), solve(vector(ray.direction))};
}

std::string sign_word(int sign) { return sign > 0 ? "positive" : sign < 0 ? "negative" : "zero"; }

class Explainer {
 public:
  Explainer(const PlacedShape& placed, const Ray& ray)
      : shape_(placed.shape), ray_(ray), object_(object_ray(placed.world_from_object, ray)) {}

  Explanation explain() {
    switch (shape_.kind) {
      case ShapeKind::triangle:
        triangle();
        break;
      case ShapeKind::sphere:
        sphere();
        break;
      case ShapeKind::box:
        box();
        break;
      case ShapeKind::cylinder:
        cylinder();
        break;
      case ShapeKind::cone:
        cone();
        break;
      case ShapeKind::mesh:
        throw std::invalid_argument("a mesh is explained a triangle at a time");
    }
    return std::move(result_);
  }

 private:
  void say(std::string sentence) { result_.steps.push_back(std::move(sentence)); }
  const Rational& put(std::string name, std::string formula, const Rational& value) {
    result_.numbers.push_back(number(std::move(name), std::move(formula), value));
    return value;
  }

  void triangle() {
    const RationalVector a = minus(vector(shape_.vertices[0]), object_.origin);
    const RationalVector b = minus(vector(shape_.vertices[1]), object_.origin);
    const RationalVector c = minus(vector(shape_.vertices[2]), object_.origin);
    const RationalVector& d = object_.direction;
    const Rational u = dot(d, cross(c, b)), v = dot(d, cross(a, c)), w = dot(d, cross(b, a));
    const Rational sum = u + v + w;
    const Rational t = dot(a, cross(c, b));
    put("U", "d . (C x B), with A, B, C the vertices from the origin: the side of edge bc", u);
    put("V", "d . (A x C): the side of edge ca", v);
    put("W", "d . (B x A): the side of edge ab", w);
    put("D", "U + V + W: the ray against the plane", sum);
    put("T", "A . (C x B): the origin against the plane", t);
    const auto [low, high] = std::minmax({sgn(u), sgn(v), sgn(w)});
    if (low < 0 && high > 0) return say("U, V and W have both signs: the line passes outside of an edge. A miss.");
    if (sum == 0)
      return say("U, V and W are zero: the ray lies in the plane, or the triangle has no area. A miss by convention.");
    if (low == 0 || high == 0)
      say("One of U, V, W is exactly zero: the line meets an edge or a vertex. Either answer is right for this "
          "triangle alone.");
    else
      say("U, V and W are all " + sign_word(high) + ": the line passes inside of all three edges.");
    const Rational at = t / sum;
    put("t", "T / D", at);
    put("u", "V / D, weight of the second vertex", Rational(v / sum));
    put("v", "W / D, weight of the third vertex", Rational(w / sum));
    range(at);
  }

  void range(const Rational& t) {
    const auto below = [&](double end) { return std::isinf(end) ? end > 0 : t < exact(end); };
    const auto above = [&](double end) { return std::isinf(end) ? end < 0 : t > exact(end); };
    if (below(ray_.t_min)) return say("t lies before t_min.");
    if (above(ray_.t_max)) return say("t lies beyond t_max.");
    say("t lies in the range.");
  }

  /// a t^2 + 2 b t + c, and its roots as they stand.
  void quadratic(const Rational& a, const Rational& b, const Rational& c, const std::string& of) {
    put("a", of + ": a t^2 + 2 b t + c", a);
    put("b", "half of the linear coefficient", b);
    put("c", sgn(c) == 0 ? "the origin is on it" : sgn(c) > 0 ? "the origin is outside" : "the origin is inside", c);
    if (a == 0) {
      if (b == 0) return say("a and b are zero: the line never crosses the " + of + ".");
      put("t", "-c / (2 b)", Rational(-c / (2 * b)));
      return;
    }
    const Rational discriminant = b * b - a * c;
    put("disc", "b^2 - a c", discriminant);
    if (discriminant < 0) return say("The discriminant is negative: the line misses the " + of + ".");
    if (discriminant == 0) {
      say("The discriminant is exactly zero: the line touches the " + of + ". Either answer is right.");
      put("t", "-b / a", Rational(-b / a));
      return;
    }
    say("The discriminant is positive: the line crosses the " + of + " twice.");
    mpf_class root(0, kBits);
    root = sqrt(to_float(discriminant));
    for (const int side : {sgn(a) < 0 ? 1 : -1, sgn(a) < 0 ? -1 : 1}) {
      mpf_class t(0, kBits);
      t = (to_float(-b) + side * root) / to_float(a);
      const Rational minus_b = -b;
      result_.numbers.push_back({side * sgn(a) < 0 ? "t1" : "t2",
                                 side < 0 ? "(-b - sqrt(disc)) / a" : "(-b + sqrt(disc)) / a",
                                 "(" + minus_b.get_str() + (side < 0 ? " - sqrt(" : " + sqrt(") +
                                     discriminant.get_str() + ")) / (" + a.get_str() + ")",
                                 decimal(t), sgn(t)});
    }
  }

  void sphere() {
    const RationalVector f = minus(object_.origin, vector(shape_.center));
    const Rational r = exact(shape_.radius);
    quadratic(dot(object_.direction, object_.direction), dot(object_.direction, f), dot(f, f) - r * r, "sphere");
  }

  void slab(std::size_t axis, const Rational& low, const Rational& high) {
    const Rational& o = object_.origin[axis];
    const Rational& d = object_.direction[axis];
    const std::string name(1, "xyz"[axis]);
    if (d == 0) {
      say("The direction's " + name + " is zero: the line runs " + (o < low || o > high ? "outside of" : "within") +
          " the slab of " + name + " for all t.");
      return;
    }
    Rational enter = (low - o) / d, leave = (high - o) / d;
    if (enter > leave) std::swap(enter, leave);
    put("enter_" + name, "where the line enters the slab of " + name, enter);
    put("leave_" + name, "and leaves it", leave);
  }

  void box() {
    const RationalVector low = vector(shape_.min), high = vector(shape_.max);
    for (std::size_t axis = 0; axis < 3; ++axis) slab(axis, low[axis], high[axis]);
    say("The line is in the box from the largest `enter` to the smallest `leave`, if that is no empty interval.");
  }

  void z_slab() {
    const Rational half = exact(shape_.height) / 2;
    slab(2, exact(shape_.center.z) - half, exact(shape_.center.z) + half);
  }

  void cylinder() {
    const RationalVector f = minus(object_.origin, vector(shape_.center));
    const RationalVector& d = object_.direction;
    const Rational r = exact(shape_.radius);
    quadratic(d[0] * d[0] + d[1] * d[1], d[0] * f[0] + d[1] * f[1], f[0] * f[0] + f[1] * f[1] - r * r, "side");
    z_slab();
    say("The line is in the cylinder where it is inside of the side and within the slab.");
  }

  void cone() {
    if (shape_.center.z == shape_.tip_z) throw std::invalid_argument("the cone's tip lies at its centre's height");
    const Rational slope = exact(shape_.radius) / (exact(shape_.center.z) - exact(shape_.tip_z));
    RationalVector f = minus(object_.origin, vector(shape_.center));
    f[2] = slope * (object_.origin[2] - exact(shape_.tip_z));
    const RationalVector& d = object_.direction;
    const Rational dz = slope * d[2];
    quadratic(d[0] * d[0] + d[1] * d[1] - dz * dz, d[0] * f[0] + d[1] * f[1] - dz * f[2],
              f[0] * f[0] + f[1] * f[1] - f[2] * f[2], "side");
    z_slab();
    say("The line is in the cone where it is inside of the side (outside of the roots if a < 0) and within the slab.");
  }

  const Shape& shape_;
  const Ray& ray_;
  ObjectRay object_;
  Explanation result_;
};

}  // namespace

Explanation explain_ray(const PlacedShape& shape, const Ray& ray) { return Explainer(shape, ray).explain(); }

Explanation explain_bounds(const PlacedShape& placed) {
  const Bounds3 box = exact_bounds(placed);
  Explanation result;
  const auto face = [&](const char* end, int axis, double value, const char* formula) {
    result.numbers.push_back({std::string(end) + " " + "xyz"[axis], formula, exact(value).get_str(),
                              decimal(to_float(exact(value))),
                              value > 0   ? 1
                              : value < 0 ? -1
                                          : 0});
  };
  for (int axis = 0; axis < 3; ++axis) {
    face("min", axis, box.min[axis], "the largest double that is not above any point");
    face("max", axis, box.max[axis], "the smallest double that is not below any point");
  }
  return result;
}

std::string exact_text(double value) {
  if (!std::isfinite(value)) return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
  const Rational q(value);
  return q.get_str() + " = " + decimal(to_float(q));
}

}  // namespace plumb

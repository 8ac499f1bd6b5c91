#include "reference/solid_rational_line.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace plumb {
namespace {

mpq_class square(const mpq_class& x) { return x * x; }

mpz_class whole(const mpq_class& x, const mpz_class& multiple_of_denominator) {
  return x.get_num() * (multiple_of_denominator / x.get_den());
}

mpq_class dot(const RationalPoint& a, const RationalPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

WholeNormal multiplied_out(const RationalPoint& at, const RationalPoint& slope) {
  mpz_class factor = 1;
  for (std::size_t j = 0; j < 3; ++j) factor = lcm(factor, lcm(at[j].get_den(), slope[j].get_den()));
  WholeNormal n;
  for (std::size_t j = 0; j < 3; ++j) {
    n.at[j] = whole(at[j], factor);
    n.slope[j] = whole(slope[j], factor);
  }
  return n;
}

}  // namespace

bool invert(const AffineMatrix& matrix, RationalMatrix& inverse) {
  RationalMatrix m;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      m[r][c] = matrix[r][c];
      inverse[r][c] = r == c ? 1 : 0;
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {
    std::size_t pivot = c;
    while (pivot < 3 && m[pivot][c] == 0) ++pivot;
    if (pivot == 3) return false;
    std::swap(m[c], m[pivot]);
    std::swap(inverse[c], inverse[pivot]);
    const mpq_class scale = 1 / m[c][c];
    for (std::size_t k = 0; k < 3; ++k) {
      m[c][k] *= scale;
      inverse[c][k] *= scale;
    }
    for (std::size_t r = 0; r < 3; ++r) {
      if (r == c) continue;
      const mpq_class factor = m[r][c];
      for (std::size_t k = 0; k < 3; ++k) {
        m[r][k] -= factor * m[c][k];
        inverse[r][k] -= factor * inverse[c][k];
      }
    }
  }
  return true;
}

double double_near(const mpq_class& x) {
  static const mpq_class kLargest(std::numeric_limits<double>::max());
  if (x > kLargest) return std::numeric_limits<double>::max();
  if (x < -kLargest) return std::numeric_limits<double>::lowest();
  return x.get_d();
}

RationalLine::RationalLine(const PlacedShape& placed, const RationalMatrix& inverse, const Ray& ray)
    : placed_(placed), inverse_(inverse), has_side_(placed.shape.kind != ShapeKind::box) {
  RationalPoint o, d;
  for (std::size_t j = 0; j < 3; ++j) {
    o[j] = mpq_class(ray.origin[static_cast<int>(j)]) - mpq_class(placed.world_from_object[j][3]);
    d[j] = ray.direction[static_cast<int>(j)];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    origin_[i] = dot(inverse[i], o);
    direction_[i] = dot(inverse[i], d);
  }
  const Shape& shape = placed.shape;
  if (!has_side_) {
    for (std::size_t i = 0; i < 3; ++i) {
      const int axis = static_cast<int>(i);
      slabs_.push_back({i, mpq_class(shape.min[axis]), mpq_class(shape.max[axis])});
    }
    return;
  }
  if (shape.kind != ShapeKind::sphere) {
    const mpq_class half = mpq_class(shape.height) / 2;
    slabs_.push_back({2, shape.center.z - half, shape.center.z + half});
  }
  const mpq_class c = side_at(origin_);
  const mpq_class after = side_at(point_at(1));
  const mpq_class before = side_at(point_at(-1));
  const mpq_class a = (after + before) / 2 - c;
  const mpq_class b = (after - before) / 2;
  const mpz_class factor = lcm(lcm(a.get_den(), b.get_den()), c.get_den());
  a_ = whole(a, factor);
  b_ = whole(b, factor);
  c_ = whole(c, factor);
  if (a == 0) return;
  vertex_ = -b / (2 * a);
  distance_square_ = square(vertex_) - c / a;
}

RationalPoint RationalLine::point_at(const mpq_class& t) const {
  RationalPoint p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = origin_[i] + t * direction_[i];
  return p;
}

mpq_class RationalLine::side_at(const RationalPoint& p) const {
  const Shape& s = placed_.shape;
  const mpq_class x = p[0] - s.center.x;
  const mpq_class y = p[1] - s.center.y;
  const mpq_class across = square(x) + square(y);
  if (s.kind == ShapeKind::sphere) return across + square(p[2] - s.center.z) - square(mpq_class(s.radius));
  if (s.kind == ShapeKind::cylinder) return across - square(mpq_class(s.radius));
  const mpq_class slope = mpq_class(s.radius) / (mpq_class(s.center.z) - mpq_class(s.tip_z));
  return across - square(slope * (p[2] - s.tip_z));
}

RationalPoint RationalLine::gradient_at(const RationalPoint& p) const {
  const Shape& s = placed_.shape;
  const mpq_class x = p[0] - s.center.x;
  const mpq_class y = p[1] - s.center.y;
  if (s.kind == ShapeKind::sphere) return {x, y, p[2] - s.center.z};
  if (s.kind == ShapeKind::cylinder) return {x, y, 0};
  const mpq_class slope = mpq_class(s.radius) / (mpq_class(s.center.z) - mpq_class(s.tip_z));
  return {x, y, -square(slope) * (p[2] - s.tip_z)};
}

std::vector<Event> RationalLine::events() const {
  std::vector<mpq_class> fractions;
  for (const Slab& slab : slabs_) {
    const mpq_class& d = direction_[slab.axis];
    if (d == 0) continue;
    fractions.push_back((slab.low - origin_[slab.axis]) / d);
    fractions.push_back((slab.high - origin_[slab.axis]) / d);
  }
  const bool two_roots = a_ != 0 && distance_square_ > 0;
  if (a_ != 0 && distance_square_ == 0) fractions.push_back(vertex_);
  if (a_ == 0 && b_ != 0) fractions.push_back(mpq_class(-c_) / b_);
  std::sort(fractions.begin(), fractions.end());
  fractions.erase(std::unique(fractions.begin(), fractions.end()), fractions.end());

  std::vector<Event> events;
  for (const mpq_class& x : fractions) {
    if (two_roots && polynomial_sign(x.get_num(), x.get_den()) == 0) continue;  // stands as a root
    events.push_back({-1, x});
  }
  for (int root = 0; two_roots && root < 2; ++root) {
    const auto place = std::find_if(events.begin(), events.end(), [&](const Event& e) {
      return e.root < 0 && compare({root, {}}, e.value) < 0;
    });
    events.insert(place, {root, {}});
  }
  return events;
}

int RationalLine::polynomial_sign(const mpz_class& numerator, const mpz_class& denominator) const {
  return sgn(mpz_class((a_ * numerator + b_ * denominator) * numerator + c_ * denominator * denominator));
}

int RationalLine::compare(const Event& t, const mpz_class& numerator, const mpz_class& denominator) const {
  if (t.root < 0) return sgn(mpz_class(t.value.get_num() * denominator - numerator * t.value.get_den()));
  const int at_x = polynomial_sign(numerator, denominator) * sgn(a_);
  const bool left = sgn(mpz_class(2 * a_ * numerator + b_ * denominator)) * sgn(a_) < 0;
  if (at_x > 0) return left ? 1 : -1;
  const int own = t.root == 0 ? -1 : 1;
  if (at_x < 0) return own;
  return left == (t.root == 0) ? 0 : own;
}

int RationalLine::compare(const Event& t, const mpq_class& x) const { return compare(t, x.get_num(), x.get_den()); }

int RationalLine::sign(const Event& t, const mpq_class& p0, const mpq_class& p1) const {
  if (p1 == 0) return sgn(p0);
  return sgn(p1) * compare(t, -sgn(p1) * p0.get_num() * p1.get_den(), p0.get_den() * abs(p1.get_num()));
}

int RationalLine::sign(const Event& t, const mpz_class& p0, const mpz_class& p1, const mpz_class& p2) const {
  if (t.root < 0) {
    const mpz_class& n = t.value.get_num();
    const mpz_class& d = t.value.get_den();
    return sgn(mpz_class((p2 * n + p1 * d) * n + p0 * d * d));
  }
  // The remainder on division by the side's polynomial, times a.
  return sgn(a_) * sign(t, mpq_class(p0 * a_ - p2 * c_), mpq_class(p1 * a_ - p2 * b_));
}

std::vector<int> RationalLine::faces_at(const Event& t) const {
  std::vector<int> faces;
  if (has_side_) faces.push_back(t.root < 0 ? -sgn(side_at(point_at(t.value))) : 0);
  for (const Slab& slab : slabs_) {
    const mpq_class& o = origin_[slab.axis];
    const mpq_class& d = direction_[slab.axis];
    faces.push_back(sign(t, o - slab.low, d));
    faces.push_back(sign(t, slab.high - o, -d));
  }
  return faces;
}

std::array<mpq_class, 2> RationalLine::around(const Event& t, unsigned bits) const {
  if (t.root < 0) return {t.value, t.value};
  mpq_class low = 0;
  mpq_class high = 1 + distance_square_;  // >= its root
  const mpf_class near = sqrt(mpf_class(distance_square_, kApproximationBits));
  for (const int side : {-1, 1}) {
    mpq_class probe(near);
    probe += probe * side / (mpq_class(1) << (kApproximationBits / 2));
    (square(probe) <= distance_square_ ? low : high) = probe;
  }
  for (unsigned i = 0; i < bits; ++i) {
    const mpq_class middle = (low + high) / 2;
    (square(middle) <= distance_square_ ? low : high) = middle;
  }
  if (t.root == 0) return {vertex_ - high, vertex_ - low};
  return {vertex_ + low, vertex_ + high};
}

std::vector<int> RationalLine::faces_between(const Event& before, const Event& after) const {
  for (unsigned bits = 0;; bits = 2 * bits + 64) {
    const mpq_class low = around(before, bits)[1];
    const mpq_class high = around(after, bits)[0];
    if (low < high) return faces_at({-1, (low + high) / 2});
  }
}

bool RationalLine::double_root_at(const Event& t) const {
  return a_ != 0 && distance_square_ == 0 && t.root < 0 && t.value == vertex_;
}

mpf_class RationalLine::approximate(const Event& t) const {
  if (t.root < 0) return mpf_class(t.value, kApproximationBits);
  const mpf_class root = sqrt(mpf_class(distance_square_, kApproximationBits));
  const mpf_class vertex(vertex_, kApproximationBits);
  return t.root == 0 ? mpf_class(vertex - root) : mpf_class(vertex + root);
}

RationalPoint RationalLine::to_world(const RationalPoint& normal) const {
  RationalPoint world;
  for (std::size_t j = 0; j < 3; ++j)
    world[j] = inverse_[0][j] * normal[0] + inverse_[1][j] * normal[1] + inverse_[2][j] * normal[2];
  return world;
}

WholeNormal RationalLine::normal(const Event& t, std::uint32_t part) const {
  const Shape& shape = placed_.shape;
  const auto along = [&](std::size_t axis, int sign) {
    RationalPoint n;
    n[axis] = sign;
    return multiplied_out(to_world(n), {});
  };
  if (!has_side_) return along(part / 2, part % 2 == 0 ? -1 : 1);
  if (part != 0) return along(2, part == 1 ? -1 : 1);
  const RationalPoint at = to_world(gradient_at(origin_));
  RationalPoint slope = to_world(gradient_at(point_at(1)));
  for (std::size_t j = 0; j < 3; ++j) slope[j] -= at[j];
  for (std::size_t j = 0; j < 3; ++j)
    if (sign(t, at[j], slope[j]) != 0) return multiplied_out(at, slope);
  return along(2, shape.kind == ShapeKind::cone && shape.tip_z < shape.center.z ? -1 : 1);
}

AlgebraicT RationalLine::algebraic(const Event& t) const {
  if (t.root < 0) return {0, 1, -t.value, 0};
  return {a_, b_, c_, t.root};
}

}  // namespace plumb

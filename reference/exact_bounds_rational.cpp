#include <CGAL/Root_of_traits.h>
#include <CGAL/mpq_class.h>
#include <CGAL/mpz_class.h>

#include <vector>

#include "reference/exact_bounds_face.h"
#include "reference/exact_bounds_search.h"

namespace plumb {
namespace {

using Rational = mpq_class;
using Root = CGAL::Root_of_traits<Rational>::Root_of_2;
using Rationals = std::array<Rational, 4>;
using Matrix = std::array<Rationals, 4>;

/// The largest coordinate along the row of a disc about (x, y, z), or of a sphere if `flatness` is the radius too:
/// tangent planes h satisfy h^T Q h = 0 with the dual quadric Q = diag(r^2, r^2, flatness^2, -1) moved to the center.
/// With h = (row, row[3] - X) this is a quadratic equation in the coordinate X, whose larger root is the answer.
Root furthest(const Row& row, const Rationals& center, const Rational& radius, const Rational& flatness) {
  const std::array<Rational, 4> diagonal{radius * radius, radius * radius, flatness * flatness, Rational(-1)};
  Matrix quadric;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      // Moving by c: T diag T^T with T = [I c; 0 1].
      quadric[i][j] = -center[i] * center[j];
      if (i == j && i < 3) quadric[i][j] += diagonal[i];
    }
  // h = g - X e4: h^T Q h = g^T Q g - 2 X (Q g)_4 + X^2 Q_44.
  Rationals image;
  Rational constant = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) image[i] += quadric[i][j] * Rational(row[j]);
    constant += Rational(row[i]) * image[i];
  }
  const Rational linear = -2 * image[3];
  // Q_44 = -1; the sign is turned so that the larger root is the larger one.
  return CGAL::make_root_of_2<Rational>(Rational(1), Rational(-linear), Rational(-constant), false);
}

Rationals point(const Rational& x, const Rational& y, const Rational& z) { return {x, y, z, 1}; }

Rational image(const Row& row, const Point3& p) {
  return Rational(row[0]) * p.x + Rational(row[1]) * p.y + Rational(row[2]) * p.z + Rational(row[3]);
}

Root furthest_of_points(const Row& row, std::span<const Point3> points) {
  Rational best = image(row, points[0]);
  for (const Point3& p : points.subspan(1)) best = std::max(best, image(row, p));
  return Root(best);
}

std::vector<Point3> corners(const Shape& box) {
  std::vector<Point3> all;
  for (const double x : {box.min.x, box.max.x})
    for (const double y : {box.min.y, box.max.y})
      for (const double z : {box.min.z, box.max.z}) all.push_back({x, y, z});
  return all;
}

/// The two end discs of a cylinder or cone.
std::vector<Root> ends(const Shape& shape, const Row& row) {
  std::vector<Root> roots;
  for (const int side : {-1, 1}) {
    const Rational z = Rational(shape.center.z) + side * Rational(shape.height) / 2;
    Rational radius = shape.radius;
    if (shape.kind == ShapeKind::cone)
      radius *= (z - Rational(shape.tip_z)) / (Rational(shape.center.z) - Rational(shape.tip_z));
    roots.push_back(furthest(row, point(shape.center.x, shape.center.y, z), radius, 0));
  }
  return roots;
}

std::vector<Root> furthest_candidates(const Shape& shape, std::span<const Point3> vertices, const Row& row) {
  switch (shape.kind) {
    case ShapeKind::triangle:
      return {furthest_of_points(row, shape.vertices)};
    case ShapeKind::mesh:
      return {furthest_of_points(row, vertices)};
    case ShapeKind::box:
      return {furthest_of_points(row, corners(shape))};
    case ShapeKind::sphere:
      return {furthest(row, point(shape.center.x, shape.center.y, shape.center.z), shape.radius, shape.radius)};
    default:
      return ends(shape, row);
  }
}

}  // namespace

double upper_face_by_rationals(const Shape& shape, std::span<const Point3> vertices, const Row& row) {
  const std::vector<Root> candidates = furthest_candidates(shape, vertices, row);
  const Root& furthest = *std::max_element(candidates.begin(), candidates.end());
  return smallest_that_holds(CGAL::to_double(furthest),
                             [&](double x) { return CGAL::compare(furthest, Rational(x)) != CGAL::LARGER; });
}

}  // namespace plumb

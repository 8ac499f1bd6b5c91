#pragma once

#include <array>
#include <cmath>
#include <span>

#include "reference/exact_bounds_domain.h"

namespace plumb {

/// How far a shape reaches along a world axis, with no division and no root taken: the largest coordinate is the
/// maximum over the first `count` terms of middle + |numerator / denominator| sqrt(squares).
template <class Number>
struct Reach {
  struct Term {
    Number middle = 0, numerator = 0, denominator = 1;
  };
  std::array<Term, 2> terms;
  int count = 1;
  Number squares = 0;
};

template <class Number>
Number image(const Row& row, const Number& x, const Number& y, const Number& z) {
  return Number(row[0]) * x + Number(row[1]) * y + (Number(row[2]) * z + Number(row[3]));
}

template <class Number>
Reach<Number> reach_of_vertices(std::span<const Point3> vertices, const Row& row) {
  using std::max;
  Reach<Number> reach;
  Number& best = reach.terms[0].middle;
  best = image<Number>(row, vertices[0].x, vertices[0].y, vertices[0].z);
  for (const Point3& vertex : vertices.subspan(1)) best = max(best, image<Number>(row, vertex.x, vertex.y, vertex.z));
  return reach;
}

/// The corner that lies furthest is chosen term by term, by the signs.
template <class Number>
Reach<Number> reach_of_box(const Shape& box, const Row& row) {
  const auto furthest = [&](int axis) {
    return row[static_cast<std::size_t>(axis)] > 0 ? box.max[axis] : box.min[axis];
  };
  Reach<Number> reach;
  reach.terms[0].middle = image<Number>(row, furthest(0), furthest(1), furthest(2));
  return reach;
}

/// A direction's support function is its dot product with the center and its length times the radius, of a disc the
/// length of its part in the disc's plane. A cylinder is a disc swept along its axis; a cone's hull (also a double
/// cone's, whose radius is a convex function of z) is that of its two end discs.
template <class Number>
Reach<Number> reach_of_round(const Shape& shape, const Row& row) {
  const auto square = [&](std::size_t column) { return Number(row[column]) * Number(row[column]); };
  const Number half = Number(0.5) * Number(shape.height);
  const Point3& c = shape.center;
  Reach<Number> reach;
  reach.squares = square(0) + square(1);
  if (shape.kind == ShapeKind::cone) {
    reach.count = 2;
    for (const int end : {0, 1}) {
      const Number z = end == 0 ? Number(c.z) - half : Number(c.z) + half;
      auto& term = reach.terms[static_cast<std::size_t>(end)];
      term.middle = image<Number>(row, c.x, c.y, z);
      term.numerator = Number(shape.radius) * (z - Number(shape.tip_z));
      term.denominator = Number(c.z) - Number(shape.tip_z);
    }
    return reach;
  }
  reach.terms[0].middle = image<Number>(row, c.x, c.y, c.z);
  reach.terms[0].numerator = shape.radius;
  if (shape.kind == ShapeKind::sphere)
    reach.squares = reach.squares + square(2);
  else
    reach.terms[0].middle = reach.terms[0].middle + Number(std::fabs(row[2])) * half;
  return reach;
}

/// `vertices` are the mesh's used ones (at least one), and are looked at for a mesh only.
template <class Number>
Reach<Number> reach_of(const Shape& shape, std::span<const Point3> vertices, const Row& row) {
  switch (shape.kind) {
    case ShapeKind::triangle:
      return reach_of_vertices<Number>(shape.vertices, row);
    case ShapeKind::mesh:
      return reach_of_vertices<Number>(vertices, row);
    case ShapeKind::box:
      return reach_of_box<Number>(shape, row);
    default:
      return reach_of_round<Number>(shape, row);
  }
}

}  // namespace plumb

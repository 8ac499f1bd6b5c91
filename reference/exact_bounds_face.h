#pragma once

#include <optional>
#include <span>

#include "reference/exact_bounds_domain.h"

namespace plumb {

/// The smallest double that is at least row . p for every point p of the shape. `vertices` are a mesh's used ones, at
/// least one; the shape is within the domain. Three ways to the same answer:

/// By FilterNumber; nothing where its bound does not tell.
std::optional<double> upper_face_by_filter(const Shape& shape, std::span<const Point3> vertices, const Row& row);
/// By the signs of homogeneous polynomials in CGAL::Mpzf, squaring where a root would stand. Any range.
double upper_face_by_polynomials(const Shape& shape, std::span<const Point3> vertices, const Row& row);
/// By GMP's rationals and CGAL's roots of quadratic equations, from other formulas. Any range.
double upper_face_by_rationals(const Shape& shape, std::span<const Point3> vertices, const Row& row);

}  // namespace plumb

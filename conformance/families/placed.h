#pragma once

#include "conformance/families/solids.h"
#include "conformance/families/triangles.h"

namespace plumb {

/// Groups from the outside in, each a list of lines in file order.
using Groups = std::vector<std::vector<TransformStep>>;

/// The numbers of a line have few binary digits after the point, so that they have few decimals too and any text gives
/// them back exactly; they are floats.
TransformStep random_translation(Random& random);
/// Whole eighths of a degree about each axis.
TransformStep random_rotation(Random& random);
/// One axis or two by a power of two and some sixteenths: at most 2^bits between the largest and the smallest factor.
TransformStep random_scale(Random& random, int bits);
/// Groups of a translation, a rotation and a scale each, in any order; `bits` is shared among them.
Groups random_groups(Random& random, int depth, int bits);

/// The lines' matrices multiplied from left to right in doubles. Rotations by Transform's correctly rounded entries.
AffineMatrix product_of(const Groups& groups);
/// |A| |A^-1| of the linear part in the largest-row-sum norm, in doubles; infinity if singular.
double matrix_condition(const AffineMatrix& matrix);

/// The images, up to rounding in doubles.
Point3 mapped(const AffineMatrix& matrix, const Point3& p);

/// A sphere, box, cylinder, cone or triangle. A triangle's numbers are floats in either precision, since programs read
/// them from mesh files.
Shape any_shape(Random& random, const Rounding& rounded);
/// What rays_at aims at: inside of the solid or triangle.
Point3 inside_of(Random& random, const Shape& shape);

/// Control rays of object space, taken to world space: the origin is rounded there, and the direction is the rounded
/// way to the target.
std::vector<Ray> placed_rays(Random& random, const Shape& shape, const AffineMatrix& matrix, const Rounding& rounded);

/// The shape in its groups, with their rounded product and its matrix_condition.
FamilyCase placed_case(const Shape& shape, Groups groups, std::vector<Ray> rays, const Rounding& rounded);
/// The same with placed_rays.
FamilyCase placed_case(Random& random, const Shape& shape, Groups groups, const Rounding& rounded);

}  // namespace plumb

#include "conformance/families/placed.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumb {
namespace {

AffineMatrix matrix_of(const TransformStep& step) {
  switch (step.kind) {
    case TransformStep::Kind::translate:
      return translation(step.value);
    case TransformStep::Kind::rotate:
      return rotation_degrees(step.value);
    default:
      return scaling(step.value);
  }
}

double largest_row_sum(const AffineMatrix& m) {
  double largest_sum = 0;
  for (const auto& row : m) {
    largest_sum = std::max(largest_sum, std::fabs(row[0]) + std::fabs(row[1]) + std::fabs(row[2]));
  }
  return largest_sum;
}

}  // namespace

TransformStep random_translation(Random& random) {
  const Vec3 by{random.whole(256) / 64, random.whole(256) / 64, random.whole(256) / 64};
  return {TransformStep::Kind::translate, by};
}

TransformStep random_rotation(Random& random) {
  Vec3 by{random.whole(8 * 180) / 8, random.whole(8 * 180) / 8, random.whole(8 * 180) / 8};
  // Often about one axis alone, as people write it.
  if (random.coin()) by = Vec3{}, by[random.integer(0, 2)] = random.whole(8 * 180) / 8;
  return {TransformStep::Kind::rotate, by};
}

TransformStep random_scale(Random& random, int bits) {
  const int up = random.integer(0, bits);
  const int axis = random.integer(0, 2);
  Vec3 by{1, 1, 1};
  by[axis] = std::ldexp(1.0, up);
  by[(axis + 1) % 3] = std::ldexp(1.0, up - bits);
  for (int i = 0; i < 3; ++i) by[i] *= random.integer(12, 20) / 16.0;
  return {TransformStep::Kind::scale, by};
}

Groups random_groups(Random& random, int depth, int bits) {
  Groups groups;
  for (int left = depth; left > 0; --left) {
    const int share = left == 1 ? bits : random.integer(0, std::min(bits, 2 * bits / left));
    bits -= share;
    std::vector<TransformStep> steps{random_translation(random), random_rotation(random), random_scale(random, share)};
    std::swap(steps[0], steps[random.below(3)]);
    std::swap(steps[1], steps[1 + random.below(2)]);
    groups.push_back(std::move(steps));
  }
  return groups;
}

AffineMatrix product_of(const Groups& groups) {
  AffineMatrix product = identity_matrix();
  bool first = true;
  for (const auto& group : groups) {
    for (const TransformStep& step : group) {
      product = first ? matrix_of(step) : product * matrix_of(step);
      first = false;
    }
  }
  return product;
}

double matrix_condition(const AffineMatrix& m) {
  const auto e = [&](std::size_t r, std::size_t c) { return m[r % 3][c % 3]; };
  AffineMatrix adjugate{};
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      adjugate[c][r] = e(r + 1, c + 1) * e(r + 2, c + 2) - e(r + 1, c + 2) * e(r + 2, c + 1);
    }
  }
  const double det = e(0, 0) * adjugate[0][0] + e(0, 1) * adjugate[1][0] + e(0, 2) * adjugate[2][0];
  return largest_row_sum(m) * largest_row_sum(adjugate) / std::fabs(det);
}

Point3 mapped(const AffineMatrix& m, const Point3& p) {
  const auto row = [&](std::size_t i) { return m[i][0] * p.x + m[i][1] * p.y + m[i][2] * p.z + m[i][3]; };
  return {row(0), row(1), row(2)};
}

Shape any_shape(Random& random, const Rounding& rounded) {
  Shape triangle;
  switch (random.below(5)) {
    case 0:
      return ordinary_sphere(random, rounded);
    case 1:
      return ordinary_box(random, rounded);
    case 2:
      return ordinary_cylinder(random, rounded);
    case 3:
      return ordinary_cone(random, rounded);
    default:
      triangle.vertices = ordinary_triangle(random, Rounding(PLUMB_FLOAT));
      return triangle;
  }
}

Point3 inside_of(Random& random, const Shape& shape) {
  return shape.kind == ShapeKind::triangle ? inner_point(random, shape.vertices) : inner_point(random, shape);
}

std::vector<Ray> placed_rays(Random& random, const Shape& shape, const AffineMatrix& matrix, const Rounding& rounded) {
  std::vector<Ray> rays;
  const Rounding as_is(PLUMB_DOUBLE);
  while (rays.size() < kRaysPerCase) {
    Point3 origin, target;
    const bool hit = random.coin();
    if (shape.kind == ShapeKind::triangle) {
      origin = facing_origin(random, shape.vertices, 1, as_is);
      target = hit ? inner_point(random, shape.vertices) : outer_point(random, shape.vertices);
    } else {
      origin = outside_origin(random, shape, as_is);
      target = hit ? inner_point(random, shape) : missed_target(random, shape, origin);
    }
    rays.push_back(ray_to(rounded(mapped(matrix, origin)), mapped(matrix, target), rounded));
  }
  return rays;
}

FamilyCase placed_case(const Shape& shape, Groups groups, std::vector<Ray> rays, const Rounding& rounded) {
  FamilyCase result = case_of(shape, std::move(rays));
  result.surface.world_from_object = rounded(product_of(groups));
  result.surface.groups = std::move(groups);
  result.condition = std::clamp(matrix_condition(result.surface.world_from_object), 1.0, rounded.largest_condition());
  return result;
}

FamilyCase placed_case(Random& random, const Shape& shape, Groups groups, const Rounding& rounded) {
  std::vector<Ray> rays = placed_rays(random, shape, rounded(product_of(groups)), rounded);
  return placed_case(shape, std::move(groups), std::move(rays), rounded);
}

}  // namespace plumb

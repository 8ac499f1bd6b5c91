#include "meshes/validation/triangle_signs.h"

#include <cmath>

#include "meshes/validation/product_sum.h"

namespace plumb {
namespace {

constexpr double kRoundoff = 0x1p-53;
/// Far above what products lose that are smaller than the normal numbers, 2^-1074 each.
constexpr double kUnderflow = 1e-300;

/// One component of (b - a) x (c - a) and the sum of the magnitudes of its two products. Either has four roundings a
/// term at most (two differences, a product, a sum), so that the value is off by less than 8 roundoffs of the sum.
struct Component {
  double value, magnitude;
};

Component component(const Vec3& u, const Vec3& v, int axis) {
  const int next = (axis + 1) % 3, after = (axis + 2) % 3;
  const double plus = u[next] * v[after], minus = u[after] * v[next];
  return {plus - minus, std::fabs(plus) + std::fabs(minus)};
}

/// Adds factor * ((b - a) x (c - a))[axis], multiplied out.
void add_component(ProductSum& sum, double factor, const Point3& a, const Point3& b, const Point3& c, int axis) {
  const int next = (axis + 1) % 3, after = (axis + 2) % 3;
  for (const auto& [p, q] : {std::pair{&a, &b}, {&b, &c}, {&c, &a}}) {
    sum.add((*p)[next], (*q)[after], factor);
    sum.subtract((*p)[after], (*q)[next], factor);
  }
}

}  // namespace

bool on_a_line(const Point3& a, const Point3& b, const Point3& c) {
  const Vec3 u = b - a, v = c - a;
  for (int axis = 0; axis < 3; ++axis) {
    const Component one = component(u, v, axis);
    // Infinity and NaN, where a number was too large, decide nothing.
    if (std::fabs(one.value) > 8 * kRoundoff * one.magnitude + kUnderflow) return false;
  }
  for (int axis = 0; axis < 3; ++axis) {
    ProductSum exact;
    add_component(exact, 1, a, b, c, axis);
    if (exact.sign() != 0) return false;
  }
  return true;
}

int side_of_normal(const Normal3& normal, const Point3& a, const Point3& b, const Point3& c) {
  const Vec3 u = b - a, v = c - a;
  double value = 0, magnitude = 0, size = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const Component one = component(u, v, axis);
    value += normal[axis] * one.value;
    magnitude += std::fabs(normal[axis]) * one.magnitude;
    size += std::fabs(normal[axis]);
  }
  // A product and two sums more: seven roundings a term at most, of sixteen.
  if (std::fabs(value) > 16 * kRoundoff * magnitude + kUnderflow * size) return value > 0 ? 1 : -1;
  ProductSum exact;
  for (int axis = 0; axis < 3; ++axis) add_component(exact, normal[axis], a, b, c, axis);
  return exact.sign();
}

}  // namespace plumb

#include "renderer/math/frame.h"

#include <cmath>

namespace plumb {
namespace {

/// By a power of two, so that the square neither overflows nor vanishes, and nothing that shows is rounded.
Vec3 scaled_to_one(const Vec3& v) {
  const double largest = std::fmax(std::fabs(v.x), std::fmax(std::fabs(v.y), std::fabs(v.z)));
  if (!(largest > 0) || std::isinf(largest)) return {NAN, NAN, NAN};
  const int exponent = -std::ilogb(largest);
  return {std::scalbn(v.x, exponent), std::scalbn(v.y, exponent), std::scalbn(v.z, exponent)};
}

}  // namespace

std::array<Vec3, 3> frame_about(const Vec3& direction) {
  const Vec3 w = normalized(scaled_to_one(direction));
  // Perpendicular to w within the plane of its two largest components, where it is longest; one component is zero, and
  // the two products of u.w are the same number but for rounding.
  int small = std::fabs(w.x) <= std::fabs(w.y) ? 0 : 1;
  if (std::fabs(w.z) < std::fabs(w[small])) small = 2;
  const int i = (small + 1) % 3;
  const int j = (small + 2) % 3;
  const double radius = std::sqrt(w[i] * w[i] + w[j] * w[j]);
  Vec3 u;
  u[i] = -w[j] / radius;
  u[j] = w[i] / radius;
  return {u, cross(w, u), w};
}

}  // namespace plumb

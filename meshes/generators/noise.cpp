#include "meshes/generators/noise.h"

#include <cmath>
#include <initializer_list>

#include "meshes/generators/random_bits.h"

namespace plumb {
namespace {

/// 21 bits of a hash as a number from -1 to 1.
double component(std::uint64_t bits, int from) { return static_cast<double>((bits >> from) & 0x1fffff) * 0x1p-20 - 1; }

/// The slope that the noise has at a lattice point.
Vec3 gradient(std::int64_t x, std::int64_t y, std::int64_t z, std::uint64_t seed) {
  std::uint64_t hash = seed;
  for (const std::int64_t i : {x, y, z}) hash = mixed_bits(hash + 0x9e3779b97f4a7c15u * static_cast<std::uint64_t>(i));
  return {component(hash, 0), component(hash, 21), component(hash, 42)};
}

/// From 0 to 1 with first and second derivatives of zero at both ends.
double faded(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

double between(double a, double b, double share) { return a + (b - a) * share; }

/// Within -1.5 and 1.5: along each axis the weighted distance to the two lattice planes is at most 1/2.
double octave(const Point3& at, std::uint64_t seed) {
  const Point3 corner{std::floor(at.x), std::floor(at.y), std::floor(at.z)};
  const Vec3 inside = at - corner;
  const auto x = static_cast<std::int64_t>(corner.x);
  const auto y = static_cast<std::int64_t>(corner.y);
  const auto z = static_cast<std::int64_t>(corner.z);
  const auto at_corner = [&](int i, int j, int k) {
    return dot(gradient(x + i, y + j, z + k, seed), inside - Vec3{double(i), double(j), double(k)});
  };
  const auto along_x = [&](int j, int k) { return between(at_corner(0, j, k), at_corner(1, j, k), faded(inside.x)); };
  const auto along_y = [&](int k) { return between(along_x(0, k), along_x(1, k), faded(inside.y)); };
  return between(along_y(0), along_y(1), faded(inside.z));
}

}  // namespace

double noise(const Point3& at, std::uint64_t seed) {
  double sum = 0, scale = 1;
  for (std::uint64_t i = 0; i < 5; ++i) {
    sum += octave({at.x * scale, at.y * scale, at.z * scale}, mixed_bits(seed + i)) / scale;
    scale *= 2;
  }
  return sum;
}

}  // namespace plumb

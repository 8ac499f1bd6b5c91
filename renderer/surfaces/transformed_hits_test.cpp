#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "renderer/math/affine_product.h"
#include "renderer/scene_for_tests.h"

// A unit sphere under nested transforms of any condition: t means the same in both frames, and normals take the inverse
// transpose.

namespace plumb {
namespace {

/// 113 bits: at condition 1e12 the referee keeps 70 of them.
__extension__ using Quad = __float128;
using QuadVector = std::array<Quad, 3>;

Quad dot(const QuadVector& a, const QuadVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The exact inverse of the matrix's linear part, by cofactors.
std::array<QuadVector, 3> inverse_of(const AffineMatrix& m) {
  const auto e = [&](std::size_t r, std::size_t c) { return static_cast<Quad>(m[r % 3][c % 3]); };
  const auto cofactor = [&](std::size_t r, std::size_t c) {
    return e(r + 1, c + 1) * e(r + 2, c + 2) - e(r + 1, c + 2) * e(r + 2, c + 1);
  };
  const Quad det = e(0, 0) * cofactor(0, 0) + e(0, 1) * cofactor(0, 1) + e(0, 2) * cofactor(0, 2);
  std::array<QuadVector, 3> inverse;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) inverse[r][c] = cofactor(c, r) / det;
  return inverse;
}

double norm(const AffineMatrix& m) {
  double largest = 0;
  for (const auto& row : m) largest = std::max(largest, std::fabs(row[0]) + std::fabs(row[1]) + std::fabs(row[2]));
  return largest;
}

TEST(TransformedHits, KeepTheirParameterAndNormalAtAnyCondition) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> u(-1, 1);
  const OneSurface sphere("<surface type='Sphere'/>");
  double worst_t = 0, worst_normal = 0;
  int hits = 0, misses = 0, ill_conditioned = 0;
  for (int i = 0; i < 1600; ++i) {
    const int depth = 1 + i % 8;
    AffineProduct product;
    for (int k = 0; k < depth; ++k) {
      const auto factor = [&] { return std::pow(10, 6.0 / depth * u(random)); };
      product.translate({u(random), u(random), u(random)})
          .rotate_degrees({180 * u(random), 180 * u(random), 180 * u(random)})
          .scale({factor(), factor(), -factor()});
    }
    const Transform map(product.rounded());
    const double condition = norm(map.matrix()) * norm(map.inverse_matrix());
    ill_conditioned += condition > 1e8;
    const auto inverse = inverse_of(map.matrix());
    for (int k = 0; k < 10; ++k) {
      const Point3 from = map(Point3{4 * u(random), 4 * u(random), 4 * u(random)});
      double largest = 0;
      for (std::size_t r = 0; r < 3; ++r)
        largest = std::max({largest, std::fabs(from[static_cast<int>(r)]), std::fabs(map.matrix()[r][3])});
      const double terms = norm(map.inverse_matrix()) * largest + 1;
      const Ray ray{from, map(Point3{1.3 * u(random), 1.3 * u(random), 1.3 * u(random)}) - from};
      QuadVector o, d;
      for (std::size_t r = 0; r < 3; ++r) {
        o[r] = d[r] = 0;
        for (int c = 0; c < 3; ++c) {
          const auto column = static_cast<std::size_t>(c);
          o[r] += inverse[r][column] * (static_cast<Quad>(ray.origin[c]) - map.matrix()[column][3]);
          d[r] += inverse[r][column] * ray.direction[c];
        }
      }
      const Quad a = dot(d, d), b = -dot(o, d), c = dot(o, o) - 1;
      const Quad discriminant = b * b - a * c;
      // Near tangents both depend on the error's square root, and so they do on whether it is a hit.
      if (discriminant < 0.01 * a && discriminant > -0.01 * a) continue;
      const auto hit = sphere.hit(map.inverse_of(ray));
      if (discriminant < 0 || (c > 0 && b < 0)) {
        EXPECT_FALSE(hit);
        ++misses;
        continue;
      }
      ASSERT_TRUE(hit) << i;
      ++hits;
      const Quad root = std::sqrt(static_cast<long double>(discriminant));
      const Quad t = c > 0 ? (b - root) / a : (b + root) / a;
      // As a distance along the ray in the object's frame, against the size of what is added up there.
      const double speed = std::sqrt(static_cast<double>(a));
      worst_t = std::max(worst_t, std::fabs(static_cast<double>(hit->t - t)) * speed / terms);
      Vec3 expected;
      for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t m = 0; m < 3; ++m)
          expected[static_cast<int>(r)] += static_cast<double>(inverse[m][r] * (o[m] + t * d[m]));
      const Normal3 normal = normalized(map(sphere->normal(map.inverse_of(ray), *hit)));
      EXPECT_GT(dot(normal, expected), 0);
      worst_normal = std::max(worst_normal, length(cross(as_vector(normal), normalized(expected))) / terms);
    }
  }
  // In the object's frame coordinates are off by some 8u of these terms, and a t by that over the cosine of the angle
  // at the surface, which is 0.1 or more; the normal by that again over the cosine, and by what the inverse transpose
  // makes of it, up to the condition, which these terms bound too.
  EXPECT_LE(worst_t, 8 * 10 * 0x1p-53);
  EXPECT_LE(worst_normal, 8 * 100 * 0x1p-53);
  EXPECT_GT(hits, 4000);
  EXPECT_GT(misses, 4000);
  EXPECT_GT(ill_conditioned, 50);
}

}  // namespace
}  // namespace plumb

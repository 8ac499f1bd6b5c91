#include "renderer/surfaces/exact_triangle.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace plumb {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class Numbers {
 public:
  /// Of all 53 bits or of a few, zero at times.
  double operator()(int spread) {
    if (random_() % 8 == 0) return 0;
    const double x =
        u_(random_) * std::ldexp(1.0, static_cast<int>(random_() % (2 * static_cast<unsigned>(spread) + 1)) - spread);
    return random_() % 2 ? x : static_cast<double>(static_cast<float>(x));
  }
  Point3 point(int spread) {
    const double x = (*this)(spread), y = (*this)(spread), z = (*this)(spread);
    return {x, y, z};
  }

 private:
  std::mt19937_64 random_{13};
  std::uniform_real_distribution<double> u_{-1, 1};
};

struct Agreement {
  int met = 0, missed = 0;

  void check(const Ray& ray, const Transform* transform, const TriangleVertices& vertices,
             const TriangleVertices& others) {
    const ExactTriangle a(ray, transform, vertices);
    const ExactTriangle b(ray, transform, vertices, ExactTriangle::Numbers::dyadic);
    ASSERT_EQ(a.is_met(), b.is_met());
    ++(a.is_met() ? met : missed);
    if (!a.is_met()) return;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(a.t()), std::bit_cast<std::uint64_t>(b.t()));
    ASSERT_EQ(a.weight_b(), b.weight_b());
    ASSERT_EQ(a.weight_c(), b.weight_c());
    ASSERT_EQ(a.compare_t(b), 0) << "not only the same signs, the same number";
    for (const double tau : {-kInfinity, 0.0, a.t(), std::nextafter(a.t(), kInfinity), 1.0, kInfinity})
      ASSERT_EQ(a.compare_t(tau), b.compare_t(tau)) << tau;
    const ExactTriangle c(ray, transform, others);
    ASSERT_TRUE(!c.is_met() || a.compare_t(c) == -c.compare_t(b));
  }
};

TEST(ExactTriangle, BothKindsOfNumbersGiveTheSame) {
  // Spreads of exponents that fit into two digits, some that do not, and some that need nearly all of a double's range.
  Numbers number;
  Agreement agreement;
  for (const int spread : {1, 10, 30, 60, 300, 1000}) {
    for (int i = 0; i < 2000; ++i) {
      const Point3 a = number.point(spread), b = number.point(spread), c = number.point(spread);
      const Point3 target = a + 0.25 * (b - a) + 0.5 * (c - a);
      Ray ray{number.point(spread), {}};
      ray.direction = i % 2 ? target - ray.origin : number.point(spread) - Point3{};
      agreement.check(ray, nullptr, {a, b, c}, {b, c, number.point(spread)});
      if (spread > 300) continue;
      const AffineMatrix matrix{{{number(spread), number(spread), number(spread), number(spread)},
                                 {number(spread), number(spread), number(spread), number(spread)},
                                 {number(spread), number(spread), number(spread), number(spread)}}};
      try {
        const Transform transform(matrix);
        if (i % 2) ray.direction = transform(target) - ray.origin;
        agreement.check(ray, &transform, {a, b, c}, {b, c, number.point(spread)});
      } catch (const SingularTransform&) {
        continue;
      }
    }
  }
  EXPECT_GT(agreement.met, 5000);
  EXPECT_GT(agreement.missed, 5000);
}

TEST(ExactTriangle, RoundsTiesToEven) {
  // t = 1 + 2^-53, in the middle of 1 and the next number, and 1 + 3 2^-53, in the middle of odd and even.
  const Ray ray{{0.25, 0.25, -1}, {0, 0, 1}};
  const auto t_at = [&](double z) {
    // Height z above 0 by an origin that is far: t = z + 1.
    return ExactTriangle(ray, nullptr, {Point3{0, 0, z}, Point3{1, 0, z}, Point3{0, 1, z}}).t();
  };
  EXPECT_EQ(t_at(0x1p-53), 1);
  EXPECT_EQ(t_at(0x3p-53), 1 + 0x1p-51);
  EXPECT_EQ(t_at(0x1.0000001p-53), 1 + 0x1p-52);
  EXPECT_EQ(t_at(-0x1p-54), 1);
}

TEST(ExactTriangle, ComparesPlacedTrianglesInDegreeEleven) {
  // The same place by two matrices that round alike, and a hair above it.
  const Transform twice(scaling({2, 2, 2})), moved(translation({0, 0, 1}));
  const Ray ray{{0.1, 0.1, 0}, {0, 0, 0.3}};
  const ExactTriangle by_scale(ray, &twice, {Point3{0, 0, 1}, Point3{1, 0, 1}, Point3{0, 1, 1}});
  const ExactTriangle by_offset(ray, &moved, {Point3{0, 0, 1}, Point3{2, 0, 1}, Point3{0, 2, 1}});
  const ExactTriangle above(ray, &moved,
                            {Point3{0, 0, 1 + 0x1p-52}, Point3{2, 0, 1 + 0x1p-52}, Point3{0, 2, 1 + 0x1p-52}});
  ASSERT_TRUE(by_scale.is_met() && by_offset.is_met() && above.is_met());
  EXPECT_EQ(by_scale.compare_t(by_offset), 0);
  EXPECT_EQ(by_scale.compare_t(above), -1);
  EXPECT_EQ(above.compare_t(by_offset), 1);
}

}  // namespace
}  // namespace plumb

#include "reference/exact_optics.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

#include "reference/exact_bounds_cases_for_tests.h"
#include "reference/exact_optics_cross_check.h"
#include "reference/mpfr_interval.h"

namespace plumb {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

bool exact_or_neighbours(const Enclosure& e) { return e.exact() || std::nextafter(e.below, kInf) == e.above; }

struct Interface {
  double cosine, from, to;
};

std::string hex(const Interface& i) {
  std::ostringstream out;
  out << std::hexfloat << "cosine " << i.cosine << ", from " << i.from << ", to " << i.to;
  return out.str();
}

enum class Family { ordinary, critical, grazing, normal, equal, wide };

/// Where naive formulas lose their digits, or take the root of a negative number.
Interface draw(PlacedShapeCases& cases, Family family) {
  Interface i{cases.uniform(0, 1), cases.uniform(1, 2.5), cases.uniform(1, 2.5)};
  switch (family) {
    case Family::critical: {
      if (i.from < i.to) std::swap(i.from, i.to);
      const double delta = std::pow(10, cases.uniform(-16, -4)) * (cases.integer(0, 1) ? 1 : -1);
      const double sine = i.to / i.from * (1 + delta);
      i.cosine = std::sqrt(std::fmax(0, (1 - sine) * (1 + sine)));
      break;
    }
    case Family::grazing:
      i.cosine = cases.integer(0, 9) == 0 ? 0 : std::ldexp(cases.uniform(1, 2), cases.integer(-60, -8));
      break;
    case Family::normal:
      i.cosine = cases.integer(0, 9) == 0 ? 1 : 1 - std::ldexp(cases.uniform(1, 2), cases.integer(-54, -8));
      break;
    case Family::equal:
      i.to = i.from * (1 + std::ldexp(cases.uniform(-1, 1), cases.integer(-52, -8)));
      break;
    case Family::wide:
      i = {std::ldexp(i.cosine, -cases.integer(0, 60)), std::ldexp(i.from, cases.integer(-60, 60)),
           std::ldexp(i.to, cases.integer(-60, 60))};
      break;
    default:
      break;
  }
  return i;
}

TEST(ExactFresnel, KnownAnswers) {
  // ((1.5 - 1) / (1.5 + 1))^2 = 1/25, either way.
  EXPECT_EQ(exact_fresnel(1, 1, 1.5).reflectance, enclose(mpq_class(1, 25)));
  EXPECT_EQ(exact_fresnel(1, 1.5, 1).reflectance, enclose(mpq_class(1, 25)));
  EXPECT_EQ(exact_fresnel(1, 1, 1.5).refracted_cosine, (Enclosure{1, 1}));
  EXPECT_EQ(exact_fresnel(1, 1, 1.5).distance_to_critical, kInf);
  // At 60 degrees from 8 to 13: 1 - (64 / 169) (3 / 4) = (11 / 13)^2, so that the shares are (7 / 15)^2 and (7 /
  // 345)^2.
  const ExactFresnel rational = exact_fresnel(0.5, 8, 13);
  EXPECT_EQ(rational.refracted_cosine, enclose(mpq_class(11, 13)));
  EXPECT_EQ(rational.reflectance, enclose((mpq_class(49, 225) + mpq_class(49, 119025)) / 2));
  // Along the surface of something denser all is reflected, of something thinner too, and totally.
  EXPECT_EQ(exact_fresnel(0, 1, 1.5).reflectance, (Enclosure{1, 1}));
  EXPECT_FALSE(exact_fresnel(0, 1, 1.5).total_internal_reflection);
  const ExactFresnel total = exact_fresnel(0, 2, 1);
  EXPECT_TRUE(total.total_internal_reflection);
  EXPECT_EQ(total.reflectance, (Enclosure{1, 1}));
  EXPECT_EQ(total.refracted_cosine, (Enclosure{0, 0}));
  EXPECT_EQ(total.distance_to_critical, 0.75);
  // Equal indices make no interface.
  EXPECT_EQ(exact_fresnel(0.3, 1.5, 1.5).reflectance, (Enclosure{0, 0}));
  EXPECT_EQ(exact_fresnel(0.3, 1.5, 1.5).refracted_cosine, (Enclosure{0.3, 0.3}));
  EXPECT_TRUE(exact_fresnel(0, 1.5, 1.5).critical);
  EXPECT_FALSE(exact_fresnel(0, 1.5, 1.5).total_internal_reflection);
}

TEST(ExactFresnel, TheCriticalAngleLiesBetweenTwoDoubles) {
  // From 2 to 1 it is 30 degrees: a cosine of sqrt(3)/2 = 0x1.bb67ae8584caa73b...p-1, so that the double below it is
  // beyond the angle, the one above within.
  const double below = 0x1.bb67ae8584caap-1, above = 0x1.bb67ae8584cabp-1;
  EXPECT_TRUE(exact_fresnel(below, 2, 1).total_internal_reflection);
  EXPECT_FALSE(exact_fresnel(above, 2, 1).total_internal_reflection);
  EXPECT_LT(exact_fresnel(below, 2, 1).distance_to_critical, 0x1p-52);
  EXPECT_GT(exact_fresnel(below, 2, 1).distance_to_critical, 0);
  EXPECT_GT(exact_fresnel(above, 2, 1).refracted_cosine.below, 0);
  EXPECT_LT(exact_fresnel(above, 2, 1).reflectance.above, 1);
}

TEST(ExactFresnel, OutsideOfTheDomainThrows) {
  for (const Interface& i :
       {Interface{-0.1, 1, 1}, {1.1, 1, 1}, {kNaN, 1, 1}, {0.5, 0, 1}, {0.5, 1, -1}, {0.5, kInf, 1}}) {
    EXPECT_THROW(exact_fresnel(i.cosine, i.from, i.to), std::invalid_argument) << hex(i);
    EXPECT_THROW(exact_fresnel_by_angles(i.cosine, i.from, i.to, 256), std::invalid_argument) << hex(i);
  }
  EXPECT_THROW(exact_refracted({0, 0, 0}, {0, 0, 1}, 1, 1), std::invalid_argument);
  EXPECT_THROW(exact_refracted({0, 0, -1}, {0, kNaN, 1}, 1, 1), std::invalid_argument);
  EXPECT_THROW(exact_refracted({0, 0, 1}, {0, 0, 1}, 1, 1), std::invalid_argument);
  EXPECT_THROW(exact_refracted({0, 0, -1}, {0, 0, 1}, 1, 0), std::invalid_argument);
  EXPECT_THROW(exact_refracted_by_angles({0, 0, 1}, {0, 0, 1}, 1, 1, 256), std::invalid_argument);
}

/// Both ways, the second at two precisions, give the same answers.
void expect_ways_agree(Family family, int count) {
  PlacedShapeCases cases(100 + static_cast<std::uint64_t>(family));
  int total = 0, asked = 0;
  for (; asked < count; ++asked) {
    const Interface i = draw(cases, family);
    const ExactFresnel first = exact_fresnel(i.cosine, i.from, i.to);
    ASSERT_TRUE(exact_or_neighbours(first.reflectance) && exact_or_neighbours(first.refracted_cosine)) << hex(i);
    ASSERT_TRUE(first.reflectance.below >= 0 && first.reflectance.above <= 1) << hex(i);
    for (const int bits : {384, 640}) {
      const ExactFresnel second = exact_fresnel_by_angles(i.cosine, i.from, i.to, bits);
      ASSERT_EQ(first.total_internal_reflection, second.total_internal_reflection) << hex(i);
      ASSERT_EQ(first.critical, second.critical) << hex(i);
      ASSERT_EQ(first.distance_to_critical, second.distance_to_critical) << hex(i);
      ASSERT_EQ(first.reflectance, second.reflectance) << hex(i);
      ASSERT_EQ(first.refracted_cosine, second.refracted_cosine) << hex(i);
    }
    total += first.total_internal_reflection;
  }
  EXPECT_EQ(asked, count);
  if (family == Family::critical) {
    EXPECT_GT(total, count / 4);
    EXPECT_LT(total, count - count / 4);
  }
}

TEST(ExactFresnel, WaysAgreeOnOrdinaryAngles) { expect_ways_agree(Family::ordinary, 2000); }
TEST(ExactFresnel, WaysAgreeNearTheCriticalAngle) { expect_ways_agree(Family::critical, 3000); }
TEST(ExactFresnel, WaysAgreeOnGrazingLight) { expect_ways_agree(Family::grazing, 2000); }
TEST(ExactFresnel, WaysAgreeNearTheNormal) { expect_ways_agree(Family::normal, 2000); }
TEST(ExactFresnel, WaysAgreeOnNearlyEqualIndices) { expect_ways_agree(Family::equal, 2000); }
TEST(ExactFresnel, WaysAgreeOnIndicesFarApart) { expect_ways_agree(Family::wide, 2000); }

TEST(ExactFresnel, ExtremeIndicesAreDecided) {
  const double tiny = std::numeric_limits<double>::denorm_min(), huge = std::numeric_limits<double>::max();
  const ExactFresnel into = exact_fresnel(0.3, tiny, huge);
  EXPECT_EQ(into.refracted_cosine, (Enclosure{std::nextafter(1, 0), 1}));
  EXPECT_EQ(into.reflectance, (Enclosure{std::nextafter(1, 0), 1}));
  EXPECT_TRUE(exact_fresnel(0.3, huge, tiny).total_internal_reflection);
  EXPECT_EQ(exact_fresnel(tiny, 1, 1.5).reflectance, (Enclosure{std::nextafter(1, 0), 1}));
}

/// Doubles of any formula that is stable here come within a few roundings.
TEST(ExactFresnel, DoublesComeClose) {
  PlacedShapeCases cases(9);
  int compared = 0;
  for (int i = 0; i < 2000; ++i) {
    const Interface light{cases.uniform(0.1, 1), 1, cases.uniform(1.2, 2.5)};
    const ExactFresnel exact = exact_fresnel(light.cosine, light.from, light.to);
    const double c = light.cosine, n = light.to, s = std::sqrt(1 - (1 - c * c) / (n * n));
    const double rs = (c - n * s) / (c + n * s), rp = (s - n * c) / (s + n * c);
    // Each quotient is at most 1 and within ten roundings of numbers up to 5 over a sum of at least 1: 1e-14 is ample.
    ASSERT_NEAR(0.5 * (rs * rs + rp * rp), exact.reflectance.below, 1e-14) << hex(light);
    ASSERT_NEAR(s, exact.refracted_cosine.below, 1e-15) << hex(light);
    ++compared;
  }
  EXPECT_EQ(compared, 2000);
}

TEST(ExactRefracted, KnownAnswers) {
  // Straight through, whatever the lengths.
  EXPECT_EQ(exact_refracted({0, 0, -3}, {0, 0, 7}, 1, 1.5), (Vec3{0, 0, -1}));
  EXPECT_EQ(exact_refracted({3, -4, 0}, {0, 2, 0}, 1.25, 1.25), (Vec3{0.6, -0.8, 0}));
  // A sine of 3/5 times 5/4 is 3/4, beside a cosine of sqrt(7)/4 = 0.66143782776614764763...
  EXPECT_EQ(exact_refracted({3, -4, 0}, {0, 1, 0}, 5, 4), (Vec3{0.75, -0.66143782776614764763, 0}));
  // From 5 to 3 that direction would leave along the surface: exactly critical, and refracted. A bit flatter is total.
  EXPECT_EQ(exact_refracted({3, -4, 0}, {0, 1, 0}, 5, 3), (Vec3{1, 0, 0}));
  EXPECT_FALSE(exact_refracted({std::nextafter(3, 4), -4, 0}, {0, 1, 0}, 5, 3));
  EXPECT_FALSE(exact_refracted({1, 0, 0}, {0, 1, 0}, 1.5, 1));
  EXPECT_EQ(exact_refracted({1, 0, 0}, {0, 1, 0}, 1, 2), (Vec3{0.5, -0.86602540378443864676, 0}));
}

TEST(ExactRefracted, AgreesWithAnglesAndWithSnell) {
  PlacedShapeCases cases(10);
  int refracted = 0, reflected = 0;
  for (int i = 0; i < 1500; ++i) {
    const auto vector = [&] { return Vec3{cases.uniform(-1, 1), cases.uniform(-1, 1), cases.uniform(-1, 1)}; };
    Vec3 direction = vector();
    Vec3 normal = i % 10 == 0 ? -direction : vector();
    if (i % 10 == 1) normal = {0, 0, 1};
    if (i % 10 == 2) direction.x = normal.x = 0;
    if (dot(direction, normal) > 0) direction = -direction;
    const double from = cases.uniform(1, 2.5), to = i % 7 == 0 ? std::nextafter(from, 2) : cases.uniform(1, 2.5);
    const auto result = exact_refracted(direction, normal, from, to);
    ASSERT_EQ(result, exact_refracted_by_angles(direction, normal, from, to, 320)) << i;
    ++(result ? refracted : reflected);
    if (!result) continue;
    // Coordinates are off by at most 2^-54, so that lengths and cross products are by less than 1e-15.
    const Vec3 n = normalized(normal);
    ASSERT_NEAR(length(*result), 1, 1e-15);
    ASSERT_NEAR(to * length(cross(*result, n)), from * length(cross(normalized(direction), n)), 1e-14);
    ASSERT_LE(dot(*result, n), 1e-15);
  }
  EXPECT_EQ(refracted + reflected, 1500);
  EXPECT_GT(refracted, 1000);
  EXPECT_GT(reflected, 100);
}

TEST(ExactRefracted, HasTheCosineOfFresnel) {
  PlacedShapeCases cases(11);
  int compared = 0;
  for (int i = 0; i < 1000; ++i) {
    // A unit normal along z and a direction whose cosine is rational: (2 u, 0, u^2 - 1) / (1 + u^2) in small integers.
    const double p = cases.integer(1, 60), q = cases.integer(61, 1000), from = cases.uniform(1, 2),
                 to = cases.uniform(2, 3);
    const auto result = exact_refracted({2 * p * q, 0, p * p - q * q}, {0, 0, 1}, from, to);
    ASSERT_TRUE(result.has_value());
    const ExactFresnel fresnel = exact_fresnel((q * q - p * p) / (q * q + p * p), from, to);
    // The cosine is rounded to 2^-54, and its effect on the far one is smaller: the ratio of the indices, squared.
    ASSERT_NEAR(-result->z, fresnel.refracted_cosine.below, 0x1p-52);
    ++compared;
  }
  EXPECT_EQ(compared, 1000);
}

}  // namespace
}  // namespace plumb

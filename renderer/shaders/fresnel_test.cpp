#include "renderer/shaders/fresnel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace plumb {
namespace {

// Each formula below is a dozen roundings of numbers of ordinary size: 1e-15 is about 9 units of 2^-53.
constexpr double kRounding = 1e-15;

TEST(Fresnel, AtNormalIncidenceIsTheSquareOfTheIndicesRatio) {
  for (const double n : {1.0, 1.33, 1.5, 2.4, 10.0}) {
    const double expected = std::pow((n - 1) / (n + 1), 2);
    for (const Fresnel rule : {Fresnel::exact, Fresnel::schlick}) {
      EXPECT_NEAR(reflectance({1, 1, n}, rule), expected, kRounding) << n;
      EXPECT_NEAR(reflectance({1, n, 1}, rule), expected, kRounding) << n;
    }
  }
}

TEST(Fresnel, AtBrewstersAngleOnlyOnePolarisationIsReflected) {
  // tan(angle) = n makes rp = 0 and rs = (1 - n^2) / (1 + n^2), so R = rs^2 / 2.
  for (const double n : {1.33, 1.5, 2.4}) {
    const double across = (1 - n * n) / (1 + n * n);
    EXPECT_NEAR(reflectance({1 / std::sqrt(1 + n * n), 1, n}, Fresnel::exact), across * across / 2, kRounding) << n;
  }
}

TEST(Fresnel, BeyondTheCriticalAngleAllIsReflected) {
  // From 1.5 to 1 the critical angle has the cosine sqrt(1 - 1/1.5^2) = 0.745.
  const double critical = std::sqrt(1 - 1 / 2.25);
  for (const double cosine : {0.0, 0.5, critical - 1e-6}) {
    EXPECT_FALSE(refracted_cosine({cosine, 1.5, 1}));
    EXPECT_EQ(reflectance({cosine, 1.5, 1}, Fresnel::exact), 1);
    EXPECT_EQ(reflectance({cosine, 1.5, 1}, Fresnel::schlick), 1);
  }
  EXPECT_TRUE(refracted_cosine({critical + 1e-6, 1.5, 1}));
  EXPECT_LT(reflectance({critical + 1e-6, 1.5, 1}, Fresnel::exact), 0.99);
  for (const double cosine : {0.001, 0.5}) EXPECT_TRUE(refracted_cosine({cosine, 1, 1.5})) << "never on entering";
}

TEST(Fresnel, AtGrazingIncidenceAllIsReflected) {
  EXPECT_EQ(reflectance({0, 1, 1.5}, Fresnel::exact), 1);
  EXPECT_EQ(reflectance({0, 1, 1.5}, Fresnel::schlick), 1);
}

TEST(Fresnel, IsReciprocal) {
  int cases = 0;
  for (double cosine = 0.01; cosine <= 1; cosine += 0.01, ++cases) {
    const double beyond = refracted_cosine({cosine, 1, 1.5}).value();
    // The way back is steep near the critical angle: its slope there is at most about 2 / cosine.
    const double tolerance = 4 * kRounding / cosine;
    EXPECT_NEAR(reflectance({cosine, 1, 1.5}, Fresnel::exact), reflectance({beyond, 1.5, 1}, Fresnel::exact),
                tolerance);
    EXPECT_NEAR(reflectance({cosine, 1, 1.5}, Fresnel::schlick), reflectance({beyond, 1.5, 1}, Fresnel::schlick),
                tolerance);
  }
  EXPECT_GE(cases, 99);
}

TEST(Fresnel, KnownValuesAt60Degrees) {
  // n = 1.5, cosine 1/2: the refracted cosine is sqrt(1 - (3/4) / (9/4)) = sqrt(2/3).
  const double beyond = std::sqrt(2.0 / 3);
  EXPECT_NEAR(*refracted_cosine({0.5, 1, 1.5}), beyond, kRounding);
  const double parallel = (0.75 - beyond) / (0.75 + beyond);
  const double across = (0.5 - 1.5 * beyond) / (0.5 + 1.5 * beyond);
  EXPECT_NEAR(reflectance({0.5, 1, 1.5}, Fresnel::exact), (parallel * parallel + across * across) / 2, kRounding);
  // Schlick: 0.04 + 0.96 / 2^5.
  EXPECT_NEAR(reflectance({0.5, 1, 1.5}, Fresnel::schlick), 0.07, kRounding);
  EXPECT_NEAR(reflectance({beyond, 1.5, 1}, Fresnel::schlick), 0.07, kRounding)
      << "from inside, the cosine outside counts";
}

TEST(Fresnel, StaysWithinZeroAndOne) {
  int cases = 0;
  for (double cosine = 0; cosine <= 1; cosine += 1.0 / 512) {
    for (const double n : {0.5, 1.0001, 1.5, 100.0}) {
      for (const Fresnel rule : {Fresnel::exact, Fresnel::schlick}) {
        const double r = reflectance({cosine, 1, n}, rule);
        EXPECT_GE(r, 0);
        EXPECT_LE(r, 1 + kRounding);
        ++cases;
      }
    }
  }
  EXPECT_EQ(cases, 513 * 8);
}

TEST(Fresnel, DirectionsObeyTheirLaws) {
  std::mt19937_64 random(41);
  std::uniform_real_distribution<double> u(-1, 1);
  int refractions = 0, total = 0;
  for (int i = 0; i < 5000; ++i) {
    const Normal3 normal = normalized(Normal3{u(random), u(random), u(random)});
    Vec3 viewer = normalized(Vec3{u(random), u(random), u(random)});
    if (dot(normal, viewer) < 0) viewer = -viewer;
    const Interface interface { dot(normal, viewer), i % 2 ? 1.5 : 1.0, i % 2 ? 1.0 : 1.5 };
    const Vec3 mirrored = reflected(viewer, normal);
    EXPECT_NEAR(length(mirrored), 1, 10 * kRounding);
    EXPECT_NEAR(dot(normal, mirrored), interface.cosine, 10 * kRounding);
    EXPECT_NEAR(length(cross(as_vector(normal), mirrored + viewer)), 0, 10 * kRounding) << "in the plane of incidence";
    const auto beyond = refracted_cosine(interface);
    if (!beyond) {
      ++total;
      continue;
    }
    ++refractions;
    const Vec3 through = refracted(viewer, normal, interface, *beyond);
    // refracted_cosine is the root of a difference that may be small: its square is accurate to kRounding, and it
    // enters the length linearly next to a component along the normal of that same size.
    EXPECT_NEAR(length(through), 1, 10 * kRounding);
    EXPECT_NEAR(dot(normal, through), -*beyond, 10 * kRounding) << "to the far side";
    // Snell: from sin(a) = to sin(b), as vectors along the surface, with opposite sense.
    const Vec3 difference =
        interface.from * cross(as_vector(normal), viewer) + interface.to * cross(as_vector(normal), through);
    EXPECT_NEAR(length(difference), 0, 20 * kRounding);
  }
  EXPECT_GT(refractions, 2500);
  EXPECT_GT(total, 500);
}

/// 113 bits, enough for differences of squares of doubles without rounding.
__extension__ using Quad = __float128;

/// One Newton step doubles the 64 bits of the root it starts from.
Quad root(Quad square) {
  const Quad start = std::sqrt(static_cast<long double>(square));
  return start == 0 ? start : (start + square / start) / 2;
}

/// (to * cosine beyond)^2, below zero under total internal reflection.
Quad squared_beyond(const Interface& i) {
  const Quad across = Quad(i.from) * i.cosine;
  return across * across - (Quad(i.from) - i.to) * (Quad(i.from) + i.to);
}

/// The textbook formula, in 113 bits.
Quad exact_reflectance(const Interface& i) {
  const Quad squared = squared_beyond(i);
  if (squared < 0) return 1;
  const Quad from = i.from, to = i.to, cosine = i.cosine;
  const Quad beyond = root(squared) / to;
  const Quad parallel = (to * cosine - from * beyond) / (to * cosine + from * beyond);
  const Quad across = (from * cosine - to * beyond) / (from * cosine + to * beyond);
  return (parallel * parallel + across * across) / 2;
}

double units(double value, Quad exact) {
  const double size = static_cast<double>(exact);
  return std::fabs(static_cast<double>(value - exact)) / (std::nextafter(size, INFINITY) - size);
}

TEST(Fresnel, IsDecidedRightlyAtTheCriticalAngle) {
  // From 64 units of the last place, and from every distance up to 1e-4, of the critical angle's cosine.
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> u(0, 1);
  int total = 0, through = 0;
  for (int i = 0; i < 20000; ++i) {
    const double to = 1 + u(random), from = to * (1 + std::pow(10, -9 + 9.3 * u(random)));
    const double critical = std::sqrt((from - to) * (from + to)) / from;
    double cosine = critical;
    if (i % 2) {
      cosine *= 1 + (static_cast<int>(random() % 129) - 64) * 0x1p-53;
    } else {
      cosine += std::copysign(std::pow(10, -16 + 12 * u(random)), u(random) - 0.5);
    }
    if (!(cosine >= 0 && cosine <= 1)) continue;
    const Interface interface { cosine, from, to };
    const Quad squared = squared_beyond(interface);
    // In 64 bits the two terms of squared_beyond are off by two roundings each.
    if (std::fabs(static_cast<double>(squared)) > 0x1p-61 * from * from * cosine * cosine) {
      ASSERT_EQ(refracted_cosine(interface).has_value(), squared >= 0)
          << std::hexfloat << cosine << " " << from << " " << to;
    }
    ++(squared >= 0 ? through : total);
    // R = 1 - k b with b the root of what is off by 2^-61: the root of that at most, some 1e-9.
    EXPECT_NEAR(reflectance(interface, Fresnel::exact), static_cast<double>(exact_reflectance(interface)), 2e-9);
  }
  EXPECT_GT(total, 8000);
  EXPECT_GT(through, 8000);
}

TEST(Fresnel, IsRightToAFewUnitsElsewhere) {
  // Some thirty roundings of 2^-64, none of them enlarged but by Snell's difference, which is kept above 2^-8 of its
  // terms, and then the one of the result. The referee's own differences keep 60 bits down to indices that differ by
  // 1e-15.
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> u(0, 1);
  double worst = 0;
  int cases = 0, close = 0, grazing = 0;
  for (int i = 0; i < 40000; ++i) {
    const double one = 0.5 + 2 * u(random);
    const double ratio = i % 2 ? 1 + std::pow(10, -15 + 15 * u(random)) : 1 + 2 * u(random);
    const bool enters = i % 4 < 2;
    const double cosine = i % 3 == 0 ? std::pow(10, -12 * u(random)) : u(random);
    const Interface interface { cosine, enters ? one : one *ratio, enters ? one *ratio : one };
    if (interface.from == interface.to) continue;
    const Quad squared = squared_beyond(interface);
    if (squared < Quad(interface.from) * interface.from * cosine * cosine * 0x1p-8) continue;
    const Quad exact = exact_reflectance(interface);
    if (exact < 0x1p-110) continue;  // beyond what the referee resolves
    worst = std::max(worst, units(reflectance(interface, Fresnel::exact), exact));
    ++cases;
    close += ratio < 1 + 1e-8;
    grazing += cosine < 1e-6;
  }
  EXPECT_LE(worst, 1);
  EXPECT_GT(cases, 25000);
  EXPECT_GT(close, 5000);
  EXPECT_GT(grazing, 3000);
}

TEST(Fresnel, NamesFollowTheEnumeration) {
  ASSERT_EQ(fresnel_names().size(), 2u);
  EXPECT_EQ(fresnel_names()[static_cast<std::size_t>(Fresnel::exact)], "exact");
  EXPECT_EQ(fresnel_names()[static_cast<std::size_t>(Fresnel::schlick)], "schlick");
}

TEST(Fresnel, EqualIndicesReflectNothingEvenAtGrazing) {
  for (const double cosine : {0.0, 1e-300, 0.5, 1.0})
    EXPECT_EQ(reflectance({cosine, 1.5, 1.5}, Fresnel::exact), 0) << cosine;
}

}  // namespace
}  // namespace plumb

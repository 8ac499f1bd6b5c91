#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "renderer/scene_for_tests.h"

namespace plumb {
namespace {

/// Axis x = 1, y = 2, radius 2, z from 1 to 5.
OneSurface can() {
  return OneSurface("<surface type='Cylinder'><center>1 2 3</center><radius>2</radius><height>4</height></surface>");
}

TEST(Cylinder, SideIsEnteredAndLeftWithItsOutwardNormal) {
  const Ray from_right{{10, 2, 3}, {-1, 0, 0}};
  EXPECT_EQ(can().hit(from_right)->t, 7);  // 10 - 3
  EXPECT_EQ(can().normal(from_right), (Normal3{1, 0, 0}));
  const Ray from_center{{1, 2, 3}, {0, -1, 0}};
  EXPECT_EQ(can().hit(from_center)->t, 2);
  EXPECT_EQ(can().normal(from_center), (Normal3{0, -1, 0}));
}

TEST(Cylinder, CapsAreEnteredAndLeftWithTheirOutwardNormal) {
  const Ray down{{1.5, 2, 10}, {0, 0, -1}};
  EXPECT_EQ(can().hit(down)->t, 5);
  EXPECT_EQ(can().normal(down), (Normal3{0, 0, 1}));
  const Ray up{{1.5, 2, -10}, {0, 0, 1}};
  EXPECT_EQ(can().hit(up)->t, 11);
  EXPECT_EQ(can().normal(up), (Normal3{0, 0, -1}));
  const Ray from_center{{1, 2, 3}, {0, 0, -1}};
  EXPECT_EQ(can().hit(from_center)->t, 2);
  EXPECT_EQ(can().normal(from_center), (Normal3{0, 0, -1}));
}

TEST(Cylinder, SlantedRayEntersByTheCapAndLeavesByTheSide) {
  // (0,2,6) + t (1,0,-1): z = 5 at t = 1, where x = 1; x = 3 at t = 3, where z = 3.
  EXPECT_EQ(can().hit({{0, 2, 6}, {1, 0, -1}})->t, 1);
  const Ray later{{0, 2, 6}, {1, 0, -1}, 1.5, 10};
  EXPECT_EQ(can().hit(later)->t, 3);
  EXPECT_EQ(can().normal(later), (Normal3{1, 0, 0}));
}

TEST(Cylinder, DirectionOfAnyLengthScalesT) {
  EXPECT_EQ(can().hit({{10, 2, 3}, {-4, 0, 0}})->t, 1.75);
  EXPECT_EQ(can().hit({{1, 2, 10}, {0, 0, -0.25}})->t, 20);
}

TEST(Cylinder, TangentRayReportsOneHit) {
  const Ray ray{{10, 4, 3}, {-1, 0, 0}};  // touches the side at (1,4,3)
  EXPECT_EQ(can().hit(ray)->t, 9);
  EXPECT_EQ(can().normal(ray), (Normal3{0, 1, 0}));
  EXPECT_FALSE(can().hit({{10, std::nextafter(4, 5), 3}, {-1, 0, 0}}));
}

TEST(Cylinder, ParallelsToTheAxisAreClosed) {
  for (const double zero : {0.0, -0.0}) {
    EXPECT_EQ(can().hit({{3, 2, 10}, {zero, zero, -1}})->t, 5) << "along the side";
    EXPECT_FALSE(can().hit({{std::nextafter(3, 4), 2, 10}, {zero, zero, -1}}));
  }
}

TEST(Cylinder, RaysInACapAreClosed) {
  for (const double zero : {0.0, -0.0}) {
    EXPECT_EQ(can().hit({{10, 2, 5}, {-1, zero, zero}})->t, 7);
    EXPECT_EQ(can().hit({{10, 2, 1}, {-1, zero, zero}})->t, 7);
    EXPECT_FALSE(can().hit({{10, 2, std::nextafter(5, 6)}, {-1, zero, zero}}));
  }
}

TEST(Cylinder, RangeIsClosedAtBothEnds) {
  const auto t = [](double from, double to) {
    const auto hit = can().hit({{10, 2, 3}, {-1, 0, 0}, from, to});  // crossings at 7 and 11
    return hit ? hit->t : -1;
  };
  EXPECT_EQ(t(7, 7), 7);
  EXPECT_EQ(t(11, 11), 11);
  EXPECT_EQ(t(std::nextafter(7, 8), 20), 11);
  EXPECT_EQ(t(8, 10), -1);
  EXPECT_EQ(t(0, std::nextafter(7, 6)), -1);
}

TEST(Cylinder, MissesBesideAboveAndBehind) {
  EXPECT_FALSE(can().hit({{10, 2, 6}, {-1, 0, 0}}));
  EXPECT_FALSE(can().hit({{10, 2, 3}, {1, 0, 0}}));
  EXPECT_FALSE(can().hit({{10, 2, 8}, {-1, 0, -0.25}})) << "z is 6.25 at the side that faces it, 5.25 at the other";
}

TEST(Cylinder, OfNoHeightIsADisc) {
  const OneSurface disc("<surface type='Cylinder'><height>0</height></surface>");
  EXPECT_EQ(disc.hit({{0.5, 0, 3}, {0, 0, -1}})->t, 3);
  EXPECT_FALSE(disc.hit({{1.5, 0, 3}, {0, 0, -1}}));
}

TEST(Cylinder, NothingEscapesThroughTheRim) {
  // C1 of the catalogue. Separate tests of side and caps leak 3 to 5 % of these rays.
  const OneSurface cylinder = can();
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> u(-1, 1);
  int from_inside = 0, from_outside = 0, by_side = 0, by_cap = 0;
  for (int i = 0; i < 100000; ++i) {
    const double angle = std::numbers::pi * u(random);
    const Point3 rim{1 + 2 * std::cos(angle), 2 + 2 * std::sin(angle), i % 2 ? 5.0 : 1.0};
    const Point3 inside{1 + u(random), 2 + u(random), 3 + 1.5 * u(random)};
    const auto out = cylinder.hit({inside, rim - inside});
    ASSERT_TRUE(out) << "from inside to the rim, case " << i;
    EXPECT_NEAR(out->t, 1, 1e-12) << i;  // the rim is met at an angle of more than 0.1
    ++(out->part == 0 ? by_side : by_cap);
    ++from_inside;
    // The same line from beyond the rim: it runs through the inside.
    const auto in = cylinder.hit({rim + (rim - inside), inside - rim});
    ASSERT_TRUE(in) << "from outside through the rim, case " << i;
    EXPECT_NEAR(in->t, 1, 1e-12) << i;
    ++from_outside;
  }
  EXPECT_EQ(from_inside, 100000);
  EXPECT_EQ(from_outside, 100000);
  EXPECT_GT(by_side, 1000);
  EXPECT_GT(by_cap, 1000);
}

TEST(Cylinder, NearlyParallelRaysStayAccurate) {
  // C2: a ray down the axis, tilted by `tilt`, meets the cap at t = 5 at (1 + 5 tilt, 2, 5).
  int cases = 0;
  for (double tilt = 1e-15; tilt < 1e-1; tilt *= 10, ++cases) {
    EXPECT_EQ(can().hit({{1, 2, 10}, {tilt, 0, -1}})->t, 5) << tilt;
    EXPECT_EQ(can().hit({{1, 2, 3}, {tilt, 0, -1}})->t, 2) << tilt;
  }
  EXPECT_GE(cases, 13);
}

}  // namespace
}  // namespace plumb

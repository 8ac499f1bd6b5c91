#include <gmock/gmock.h>

#include <cmath>

#include "renderer/scene_for_tests.h"

namespace plumb {
namespace {

/// |x| <= 1, |y| <= 2, |z| <= 3.
OneSurface brick() { return OneSurface("<surface type='Box'><minPt>-1 -2 -3</minPt><maxPt>1 2 3</maxPt></surface>"); }

/// As solids.xml has one: z from 3.1 to 3.
OneSurface inverted() {
  return OneSurface("<surface type='Box'><minPt>-5 -6 3.1</minPt><maxPt>5 6 3</maxPt></surface>");
}

TEST(Box, IsEnteredAndLeftThroughEachFaceWithItsOutwardNormal) {
  const OneSurface box = brick();
  const double half[] = {1, 2, 3};
  int faces = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Ray ray{{0.25, 0.25, 0.25}, {}};
      ray.origin[axis] = side * 10;
      ray.direction[axis] = -side;
      Normal3 outward;
      outward[axis] = side;
      EXPECT_EQ(box.hit(ray)->t, 10 - half[axis]);
      EXPECT_EQ(box.normal(ray), outward);
      ray.direction[axis] = -2 * side;
      EXPECT_EQ(box.hit(ray)->t, (10 - half[axis]) / 2) << "t counts in lengths of the direction";
      ray.origin[axis] = 0;
      ray.direction[axis] = side;
      EXPECT_EQ(box.hit(ray)->t, half[axis]);
      EXPECT_EQ(box.normal(ray), outward);
      ++faces;
    }
  }
  EXPECT_EQ(faces, 6);
}

TEST(Box, CapitalsOfItsCornersDoNotMatter) {
  const OneSurface box("<surface type='Box'><minpt>-1 -1 -1</minpt><maxpt>0 0 0</maxpt></surface>");
  EXPECT_EQ(box.hit({{-0.5, -0.5, 5}, {0, 0, -1}})->t, 5);
}

TEST(Box, RaysInAFaceOrEdgeHit) {
  const OneSurface box = brick();
  for (const double zero : {0.0, -0.0}) {
    for (const double x : {-1.0, 1.0}) {
      EXPECT_EQ(box.hit({{x, 0.5, 10}, {zero, zero, -1}})->t, 7) << x;          // in a face
      EXPECT_EQ(box.hit({{x, 2, 10}, {zero, zero, -1}})->t, 7) << x;            // along an edge
      EXPECT_FALSE(box.hit({{x * (1 + 0x1p-52), 0.5, 10}, {zero, zero, -1}}));  // just beside it
    }
  }
}

TEST(Box, RaysThroughACornerHit) {
  // (2,4,6) - t (1,2,3) reaches all three faces at t = 1 and leaves through the other three at t = 3.
  EXPECT_EQ(brick().hit({{2, 4, 6}, {-1, -2, -3}})->t, 1);
  EXPECT_EQ(brick().hit({{2, 4, 6}, {-1, -2, -3}, 1.5, 10})->t, 3);
  // Touches nothing but the edge x = 1, y = 2: (0,3,0) + t (1,-1,0) at t = 1.
  EXPECT_EQ(brick().hit({{0, 3, 0}, {1, -1, 0}})->t, 1);
  EXPECT_FALSE(brick().hit({{0, 3.0001, 0}, {1, -1, 0}}));
}

TEST(Box, RangeIsClosedAtBothEnds) {
  const auto t = [](double from, double to) {
    const auto hit = brick().hit({{0, 0, 10}, {0, 0, -1}, from, to});  // crossings at 7 and 13
    return hit ? hit->t : -1;
  };
  EXPECT_EQ(t(7, 7), 7);
  EXPECT_EQ(t(13, 13), 13);
  EXPECT_EQ(t(std::nextafter(7, 8), 20), 13);
  EXPECT_EQ(t(0, std::nextafter(7, 6)), -1);
  EXPECT_EQ(t(8, 12), -1);
  EXPECT_EQ(t(std::nextafter(13, 14), 20), -1);
}

TEST(Box, RayBesideOrBehindMisses) {
  EXPECT_FALSE(brick().hit({{0, 0, 10}, {0, 0, 1}}));
  EXPECT_FALSE(brick().hit({{4, 0, 0}, {-1, 1, 0}}));  // past the edge x = 1 at y = 3
  EXPECT_TRUE(brick().hit({{4, 0, 0}, {-1, 0.5, 0}}));
}

TEST(Box, OfNoThicknessIsHit) {
  const OneSurface flat("<surface type='Box'><minPt>-1 -1 2</minPt><maxPt>1 1 2</maxPt></surface>");
  EXPECT_EQ(flat.hit({{0.5, 0.5, 10}, {0, 0, -1}})->t, 8);
  EXPECT_EQ(flat.hit({{0.5, 5, 2}, {0, -1, 0}})->t, 4) << "a ray in its plane meets its edge";
  EXPECT_FALSE(flat.hit({{0.5, 5, 2.0000001}, {0, -1, 0}}));
  EXPECT_TRUE(flat.warnings().empty()) << "it is not inverted";
}

TEST(InvertedBox, IsHitWhereTheCoursesLoopStarts) {
  // z: near = (3.1 - 10) / -1 = 6.9 and far = 7, swapped to 7 and 6.9, since d < 0. 0 <= 6.9 and 7 <= infinity, so the
  // start moves to 7, with no test against the end.
  const Ray down{{0, 0, 10}, {0, 0, -1}};
  EXPECT_EQ(inverted().hit(down)->t, 7);
  EXPECT_EQ(inverted().normal(down), (Normal3{0, 0, 1}));
  // From below the loop starts at the upper plane: (3.1 + 10) / 1.
  const Ray up{{0, 0, -10}, {0, 0, 1}};
  EXPECT_EQ(inverted().hit(up)->t, 13.1);
  EXPECT_EQ(inverted().normal(up), (Normal3{0, 0, -1})) << "turned against the ray";
}

TEST(InvertedBox, RunningIntervalBeginsAsTheRaysRange) {
  const auto hit = [](double from, double to) { return inverted().hit({{0, 0, 10}, {0, 0, -1}, from, to}); };
  EXPECT_TRUE(hit(0, 7));
  EXPECT_FALSE(hit(0, std::nextafter(7, 6))) << "near > end";
  EXPECT_TRUE(hit(6.5, 10));
  EXPECT_FALSE(hit(6.95, 10)) << "start > far";
}

TEST(InvertedBox, EndOfAnEarlierAxisCutsItOff) {
  // x leaves at t = 5, before z is reached at 7.
  EXPECT_FALSE(inverted().hit({{0, 0, 10}, {1, 0, -1}}));
  EXPECT_TRUE(inverted().hit({{0, 0, 10}, {0.5, 0, -1}}));
}

TEST(InvertedBox, HasTheBoundsOfItsSortedCornersAndAWarning) {
  EXPECT_EQ(inverted()->bounds(), (Bounds3{{-5, -6, 3}, {5, 6, 3.1}}));
  ASSERT_EQ(inverted().warnings().size(), 1u);
  EXPECT_THAT(inverted().warnings()[0], ::testing::HasSubstr("scene.xml:1:46: warning: minPt lies beyond maxPt in z"));
}

TEST(InvertedBox, IsFoundByTheHierarchyAsByLinearSearch) {
  const std::string elements =
      "<surface type='Sphere'><center>0 0 -4</center></surface><surface type='Box'><minPt>-5 -6 3.1</minPt><maxPt>5 6 "
      "3</maxPt></surface>";
  for (const Accel accel : {Accel::linear, Accel::bvh2, Accel::bvh8}) {
    const ReadScene read = scene_of(elements, {.overrides = {}, .fresnel = Fresnel::exact, .accel = accel});
    TraceCounters counters;
    const auto hit = read.scene.closest_hit({{0, 0, 10}, {0, 0, -1}}, counters);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->placed, 1u);
    EXPECT_EQ(hit->hit.t, 7);
  }
}

TEST(Box, RayWithNanHitsNothing) {
  const OneSurface box("<surface type='Box'><minPt>-1 -1 -1</minPt><maxPt>1 1 1</maxPt></surface>");
  EXPECT_TRUE(box.hit({{0.1, 0.2, 5}, {0, 0, -1}}));
  int rays = 0;
  for (const Ray& ray : rays_with_nan()) {
    EXPECT_FALSE(box.hit(ray)) << rays;
    ++rays;
  }
  EXPECT_EQ(rays, 8);
}

}  // namespace
}  // namespace plumb

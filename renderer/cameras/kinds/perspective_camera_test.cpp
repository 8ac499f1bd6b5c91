#include <gtest/gtest.h>

#include <cmath>

#include "renderer/scene_for_tests.h"

namespace plumb {
namespace {

Ray camera_ray(const std::string& parameters, double u, double v) {
  return scene_of("<camera>" + parameters + "</camera>").scene.camera().ray(u, v);
}

/// Both directions come out of a dozen roundings of numbers below 4.
constexpr double kRounding = 4e-15;

void expect_along(const Vec3& direction, const Vec3& expected) {
  EXPECT_NEAR(length(direction), 1, kRounding);
  EXPECT_NEAR(length(direction - normalized(expected)), 0, kRounding)
      << direction.x << " " << direction.y << " " << direction.z << " is not along " << expected.x << " " << expected.y
      << " " << expected.z;
}

TEST(PerspectiveCamera, DefaultLooksAlongMinusZThroughAUnitWindow) {
  for (const std::string& elements :
       {std::string(), std::string("<camera/>"), std::string("<camera type='Camera'/>")}) {
    const ReadScene read = scene_of(elements);
    const Camera& camera = read.scene.camera();
    EXPECT_EQ(camera.ray(0.5, 0.5).origin, (Point3{0, 0, 0}));
    EXPECT_EQ(camera.ray(0.5, 0.5).direction, (Vec3{0, 0, -1}));
    expect_along(camera.ray(0, 0).direction, {-0.5, -0.5, -1});
    expect_along(camera.ray(1, 0).direction, {0.5, -0.5, -1});
    expect_along(camera.ray(0, 1).direction, {-0.5, 0.5, -1});
    expect_along(camera.ray(1, 1).direction, {0.5, 0.5, -1});
    EXPECT_EQ(camera.ray(0, 0).t_min, 0);
    EXPECT_TRUE(std::isinf(camera.ray(0, 0).t_max));
  }
}

TEST(PerspectiveCamera, WindowHasItsOwnSizeAndDistance) {
  const std::string parameters =
      "<viewPoint>1 2 3</viewPoint><projDistance>4</projDistance><viewWidth>6</viewWidth><viewHeight>2</viewHeight>";
  EXPECT_EQ(camera_ray(parameters, 0, 0).origin, (Point3{1, 2, 3}));
  expect_along(camera_ray(parameters, 1, 1).direction, {3, 1, -4});
  expect_along(camera_ray(parameters, 0, 0.5).direction, {-3, 0, -4});
}

TEST(PerspectiveCamera, LengthsOfTheDirectionsDoNotCount) {
  const std::string parameters = "<viewDir>0 0 -7</viewDir><viewUp>0 3 0</viewUp><projNormal>0 0 .1</projNormal>";
  expect_along(camera_ray(parameters, 1, 0).direction, {0.5, -0.5, -1});
}

TEST(PerspectiveCamera, UpIsMadePerpendicularToThePlanesNormal) {
  // w = (0,0,1); up (1,1,5) leaves u = unit(up x w) = (1,-1,0)/sqrt 2 and v = w x u = (1,1,0)/sqrt 2.
  const double r = std::sqrt(0.5);
  expect_along(camera_ray("<viewUp>1 1 5</viewUp>", 1, 0.5).direction, {0.5 * r, -0.5 * r, -1});
  expect_along(camera_ray("<viewUp>1 1 5</viewUp>", 0.5, 1).direction, {0.5 * r, 0.5 * r, -1});
}

TEST(PerspectiveCamera, ObliquePlaneKeepsTheViewDirectionInItsMiddle) {
  // w = (1,0,1)/sqrt 2, u = (1,0,-1)/sqrt 2, v = (0,1,0); the window's middle stands at (0,0,-2).
  const std::string parameters = "<projNormal>1 0 1</projNormal><projDistance>2</projDistance>";
  const double r = std::sqrt(0.5);
  expect_along(camera_ray(parameters, 0.5, 0.5).direction, {0, 0, -1});
  expect_along(camera_ray(parameters, 1, 0.5).direction, {0.5 * r, 0, -2 - 0.5 * r});
  expect_along(camera_ray(parameters, 0, 0.5).direction, {-0.5 * r, 0, -2 + 0.5 * r});
  expect_along(camera_ray(parameters, 0.5, 1).direction, {0, 0.5, -2});
}

TEST(PerspectiveCamera, SignOfProjNormalHasNoEffect) {
  int rays = 0;
  for (const double u : {0.0, 0.25, 1.0}) {
    for (const double v : {0.0, 0.75, 1.0}) {
      const Ray a = camera_ray("<viewDir>1 2 -3</viewDir><projNormal>1 .5 -2</projNormal>", u, v);
      const Ray b = camera_ray("<viewDir>1 2 -3</viewDir><projNormal>-1 -.5 2</projNormal>", u, v);
      EXPECT_EQ(a.direction, b.direction);
      ++rays;
    }
  }
  EXPECT_EQ(rays, 9);
}

TEST(PerspectiveCamera, IsNotMirrored) {
  // Looking along +z with y up, x grows to the left.
  expect_along(camera_ray("<viewDir>0 0 1</viewDir>", 1, 0.5).direction, {-0.5, 0, 1});
}

}  // namespace
}  // namespace plumb

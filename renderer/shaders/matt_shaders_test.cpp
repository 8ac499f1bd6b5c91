#include <gtest/gtest.h>

#include <cmath>

#include "meshes/formats/write_msh.h"
#include "renderer/scene_for_tests.h"

// Lambertian and Phong on a floor whose top is the plane z = 0, and what stands between it and the light.

namespace plumb {
namespace {

const std::string kFloor = "<surface type='Box'><minPt>-9 -9 -1</minPt><maxPt>9 9 0</maxPt><shader ref='s'/></surface>";
const std::string kGrey = "<shader name='s' type='Lambertian'><diffuseColor>.5 .25 1</diffuseColor></shader>";

std::string light(const std::string& position, const std::string& intensity = "1 1 1") {
  return "<light><position>" + position + "</position><intensity>" + intensity + "</intensity></light>";
}

Color seen_from_above(const std::string& elements, const Point3& at = {0, 0, 0}) {
  return traced(scene_of(elements).scene, {{at.x, at.y, 1}, {0, 0, -1}});
}

constexpr Color kBlack{0, 0, 0};
// What the formulas round: a handful of operations on numbers of at most 1.
constexpr double kRounding = 1e-15;

void expect_near(const Color& color, const Color& expected) {
  EXPECT_NEAR(color.r, expected.r, kRounding);
  EXPECT_NEAR(color.g, expected.g, kRounding);
  EXPECT_NEAR(color.b, expected.b, kRounding);
}

TEST(Lambertian, IsDiffuseTimesIntensityTimesCosine) {
  EXPECT_EQ(seen_from_above(kGrey + kFloor + light("0 0 2", "1 2 .5")), (Color{0.5, 0.5, 0.5}));
  // Seen from (2,0,0) the light stands at 45 degrees; distance does not count.
  const double cosine = std::sqrt(0.5);
  expect_near(seen_from_above(kGrey + kFloor + light("0 0 2"), {2, 0, 0}), {0.5 * cosine, 0.25 * cosine, cosine});
}

TEST(Lambertian, LightsAdd) {
  EXPECT_EQ(seen_from_above(kGrey + kFloor + light("0 0 2") + light("0 0 200", ".5 .5 .5")), (Color{0.75, 0.375, 1.5}))
      << "not clamped";
}

TEST(Lambertian, WithoutLightIsBlack) { EXPECT_EQ(seen_from_above(kGrey + kFloor), kBlack); }

TEST(Lambertian, LightsColorIsAnotherNameOfItsIntensity) {
  EXPECT_EQ(seen_from_above(kGrey + kFloor + "<light><position>0 0 2</position><color>0 1 0</color></light>"),
            (Color{0, 0.25, 0}));
}

/// A triangle in the plane z = 0 whose normal is +z: it has nothing behind it that could block.
std::string sheet() {
  TriangleMesh mesh;
  mesh.positions = {{-4, -4, 0}, {4, -4, 0}, {0, 8, 0}};
  mesh.triangles = {{0, 1, 2}};
  write_msh(mesh, scene_test_file("sheet.msh"));
  return "<surface type='Mesh'><data>sheet.msh</data><shader ref='s'/></surface>";
}

TEST(Lambertian, IsLitOnTheSideOfItsNormalOnly) {
  const ReadScene above = scene_of(kGrey + sheet() + light("0 0 2"));
  const ReadScene below = scene_of(kGrey + sheet() + light("0 0 -2"));
  const Ray down{{0, 0, 1}, {0, 0, -1}}, up{{0, 0, -1}, {0, 0, 1}};
  EXPECT_EQ(traced(above.scene, down), (Color{0.5, 0.25, 1}));
  EXPECT_EQ(traced(above.scene, up), (Color{0.5, 0.25, 1})) << "where it is seen from does not matter";
  EXPECT_EQ(traced(below.scene, down), kBlack);
  EXPECT_EQ(traced(below.scene, up), kBlack);
}

TEST(Shadow, OnlyWhatStandsBeforeTheLightBlocks) {
  const auto with_ball_at = [](const std::string& z, const std::string& shader = "s") {
    return seen_from_above(kGrey + "<shader name='glass' type='Glass'><refractiveIndex>1.5</refractiveIndex></shader>" +
                           kFloor + light("2 0 4") + "<surface type='Sphere'><center>" + z +
                           "</center><radius>.25</radius><shader ref='" + shader + "'/></surface>");
  };
  const Color lit = seen_from_above(kGrey + kFloor + light("2 0 4"));
  EXPECT_GT(lit.r, 0.4);
  EXPECT_EQ(with_ball_at("1 0 2"), kBlack) << "half way to the light";
  EXPECT_EQ(with_ball_at("1 0 2", "glass"), kBlack) << "glass blocks as well";
  EXPECT_EQ(with_ball_at("4 0 8"), lit) << "beyond the light";
  EXPECT_EQ(with_ball_at("-1 0 -2"), lit) << "below the floor";
  EXPECT_EQ(with_ball_at("1 1 2"), lit) << "beside the way";
}

TEST(Shadow, ASurfaceExactlyAtTheLightBlocks) {
  // The range of a shadow ray is closed: t = 1 counts.
  const std::string lid = "<surface type='Box'><minPt>-1 -1 2</minPt><maxPt>1 1 3</maxPt></surface>";
  EXPECT_EQ(seen_from_above(kGrey + kFloor + light("0 0 2") + lid), kBlack);
  EXPECT_NE(seen_from_above(kGrey + kFloor + light("0 0 1.999999") + lid), kBlack);
}

TEST(Shadow, ASurfaceNearerThanTheOffsetDoesNotBlock) {
  // The light is 1000 away, so t = 1e-6 is 0.001: a sheet at half of that is not seen, one at twice is.
  const auto lid = [](const std::string& z) {
    return "<surface type='Box'><minPt>-1 -1 " + z + "</minPt><maxPt>1 1 " + z + "</maxPt></surface>";
  };
  const auto color = [&](const std::string& z) {
    return traced(scene_of(kGrey + kFloor + light("0 0 1000") + lid(z)).scene, {{0, 0, 0.0001}, {0, 0, -1}});
  };
  EXPECT_EQ(color("0.0005"), (Color{0.5, 0.25, 1}));
  EXPECT_EQ(color("0.002"), kBlack);
}

const std::string kShiny =
    "<shader name='s' type='Phong'><diffuseColor>.5 .25 0</diffuseColor><specularColor>.25 .5 "
    "1</specularColor><exponent>10</exponent></shader>";

TEST(Phong, HighlightIsFullWhereTheHalfVectorIsTheNormal) {
  // Viewer along (3,0,4)/5, light along (-3,0,4)/5: h = n and n.l = 0.8.
  const ReadScene read = scene_of(kShiny + kFloor + light("-3 0 4", "1 .5 .25"));
  const Color color = traced(read.scene, {{3, 0, 4}, {-3, 0, -4}});
  expect_near(color, {1 * (0.8 * 0.5 + 0.25), 0.5 * (0.8 * 0.25 + 0.5), 0.25 * (0 + 1)});
}

TEST(Phong, HighlightFallsWithThePowerOfTheHalfVectorsCosine) {
  // Viewer (3,0,4)/5, light (0,0,1): h along (0.6, 0, 1.8), n.h = 1.8 / sqrt(3.6), so (n.h)^10 = 0.9^5.
  const ReadScene read = scene_of(kShiny + kFloor + light("0 0 2"));
  const double highlight = std::pow(0.9, 5);
  const Color color = traced(read.scene, {{3, 0, 4}, {-3, 0, -4}});
  EXPECT_NEAR(color.r, 0.5 + 0.25 * highlight, 10 * kRounding);  // a power of 10 has 10 times its base's error
  EXPECT_NEAR(color.g, 0.25 + 0.5 * highlight, 10 * kRounding);
  EXPECT_NEAR(color.b, highlight, 10 * kRounding);
}

TEST(Phong, HighlightShowsWhereTheDiffusePartIsZero) {
  // The rule has no test of n.l in the highlight: light just below the sheet's horizon, h still above it.
  const ReadScene read = scene_of("<shader name='s' type='Phong'/>" + sheet() + light("-8 0 -1"));
  const Color color = traced(read.scene, {{2, 0, 2}, {-2, 0, -2}});
  const Vec3 half = normalized(normalized(Vec3{-8, 0, -1}) + normalized(Vec3{2, 0, 2}));
  EXPECT_GT(half.z, 0.1);
  EXPECT_NEAR(color.r, half.z, kRounding);
}

TEST(Phong, InShadowIsBlack) {
  const std::string ball = "<surface type='Sphere'><center>0 0 3</center></surface>";
  EXPECT_EQ(seen_from_above(kShiny + kFloor + light("0 0 8") + ball), kBlack);
}

TEST(Phong, DefaultsAreWhiteWithExponentOne) {
  EXPECT_EQ(seen_from_above("<shader name='s' type='Phong'/>" + kFloor + light("0 0 2")), (Color{2, 2, 2}));
}

}  // namespace
}  // namespace plumb

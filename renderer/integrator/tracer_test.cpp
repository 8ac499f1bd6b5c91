#include "renderer/integrator/tracer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "meshes/formats/write_msh.h"
#include "renderer/scene_for_tests.h"

namespace plumb {
namespace {

std::uint64_t rays(const TraceCounters& counters, RayKind kind) {
  return counters.rays[static_cast<std::size_t>(kind)];
}

/// Floor below z = 0 and ceiling above z = 1 under a glaze of index 3, whose R at normal incidence is exactly 1/4.
std::string facing_mirrors(const std::string& more) {
  return more +
         "<shader name='m' type='Glazed'><refractiveIndex>3</refractiveIndex><substrate type='Lambertian'/></shader>"
         "<surface type='Box'><minPt>-9 -9 -1</minPt><maxPt>9 9 0</maxPt><shader ref='m'/></surface>"
         "<surface type='Box'><minPt>-9 -9 1</minPt><maxPt>9 9 2</maxPt><shader ref='m'/></surface>";
}

TraceCounters between_mirrors(const std::string& more, const BuildOptions& options = {}) {
  TraceCounters counters;
  traced(scene_of(facing_mirrors(more), options).scene, {{0, 0, 0.5}, {0, 0, -1}}, &counters);
  return counters;
}

TEST(Tracer, DropsRaysThatCountForLessThanTheMinimum) {
  // Contributions are 1/4, 1/16, 1/64, 1/256: the last is below 0.01.
  EXPECT_EQ(rays(between_mirrors(""), RayKind::reflection), 3u);
  EXPECT_EQ(rays(between_mirrors("<minContribution>.0625</minContribution>"), RayKind::reflection), 2u)
      << "equal is kept";
  EXPECT_EQ(rays(between_mirrors("<minContribution>.0626</minContribution>"), RayKind::reflection), 1u);
  EXPECT_EQ(rays(between_mirrors("<minContribution>1</minContribution>"), RayKind::reflection), 0u);
}

TEST(Tracer, DropsRaysDeeperThanTheMaximum) {
  // The camera's ray has depth 1, so 11 reflections reach depth 12.
  EXPECT_EQ(rays(between_mirrors("<minContribution>0</minContribution>"), RayKind::reflection), 11u);
  EXPECT_EQ(rays(between_mirrors("<minContribution>0</minContribution><maxDepth>5</maxDepth>"), RayKind::reflection),
            4u);
  EXPECT_EQ(rays(between_mirrors("<maxDepth>1</maxDepth>"), RayKind::reflection), 0u);
}

TEST(Tracer, OverridesTakeThePlaceOfTheScenesLimits) {
  BuildOptions options;
  options.overrides.max_depth = 7;
  options.overrides.min_contribution = 0;
  EXPECT_EQ(rays(between_mirrors("<maxDepth>2</maxDepth>", options), RayKind::reflection), 6u);
}

TEST(Tracer, TheSubstratesShareShrinksWhatItSendsOn) {
  // A glaze of R = 1/4 over the same glaze: from the top one 1/4, from the lower one 3/4 * 1/4 = 3/16.
  const std::string twice =
      "<shader name='m' type='Glazed'><refractiveIndex>3</refractiveIndex><substrate "
      "type='Glazed'><refractiveIndex>3</refractiveIndex>"
      "<substrate type='Lambertian'/></substrate></shader><surface type='Box'><minPt>-9 -9 -1</minPt><maxPt>9 9 "
      "0</maxPt><shader ref='m'/></surface>";
  const auto reflections = [&](const std::string& minimum) {
    TraceCounters counters;
    traced(scene_of("<minContribution>" + minimum + "</minContribution>" + twice).scene, {{0, 0, 0.5}, {0, 0, -1}},
           &counters);
    return rays(counters, RayKind::reflection);
  };
  EXPECT_EQ(reflections(".1875"), 2u);
  EXPECT_EQ(reflections(".1876"), 1u);
}

TEST(Tracer, CountsRaysAndTests) {
  TraceCounters counters;
  const ReadScene read = scene_of(
      "<light><position>0 0 5</position></light><light><position>0 1 5</position></light><surface type='Sphere'/>",
      {.overrides = {}, .fresnel = Fresnel::exact, .accel = Accel::linear});
  traced(read.scene, {{0, 0, 3}, {0, 0, -1}}, &counters);
  EXPECT_EQ(counters.rays, (std::array<std::uint64_t, kRayKinds>{1, 0, 0, 2}));
  EXPECT_EQ(counters.primitive_tests, 3u) << "one sphere, for each ray";
  traced(read.scene, {{0, 0, 3}, {0, 0, 1}}, &counters);
  EXPECT_EQ(rays(counters, RayKind::shadow), 0u) << "the background has no shadow";
}

TEST(Glazed, IsSubstrateAndMirrorImageByFresnel) {
  // From above onto a red floor, R = 0.04; the mirror image is the lit underside of a white ball.
  const ReadScene read = scene_of(
      "<light><position>0 0 2</position></light><surface type='Sphere'><center>0 0 6</center></surface>"
      "<surface type='Box'><minPt>-9 -9 -1</minPt><maxPt>9 9 0</maxPt><shader "
      "type='Glazed'><refractiveIndex>1.5</refractiveIndex>"
      "<substrate type='Lambertian'><diffuseColor>1 0 0</diffuseColor></substrate></shader></surface>");
  const Color color = traced(read.scene, {{0, 0, 1}, {0, 0, -1}});
  EXPECT_NEAR(color.r, 1, 1e-15);
  EXPECT_NEAR(color.g, 0.04, 1e-15);
  EXPECT_NEAR(color.b, 0.04, 1e-15);
}

TEST(Glazed, SeenFromBehindIsItsSubstrateAlone) {
  TriangleMesh mesh;
  mesh.positions = {{-4, -4, 0}, {4, -4, 0}, {0, 8, 0}};
  mesh.triangles = {{0, 1, 2}};
  write_msh(mesh, scene_test_file("pane.msh"));
  const ReadScene read = scene_of(
      "<light><position>0 0 2</position></light><surface type='Mesh'><data>pane.msh</data><shader "
      "type='Glazed'><refractiveIndex>3</refractiveIndex>"
      "<substrate type='Lambertian'><diffuseColor>1 .5 0</diffuseColor></substrate></shader></surface>");
  TraceCounters counters;
  EXPECT_EQ(traced(read.scene, {{0, 0, -1}, {0, 0, 1}}, &counters), (Color{1, 0.5, 0}));
  EXPECT_EQ(rays(counters, RayKind::reflection), 0u);
  EXPECT_EQ(traced(read.scene, {{0, 0, 1}, {0, 0, -1}}, &counters), (Color{0.75, 0.375, 0}))
      << "from the front, 1 - R of it";
  EXPECT_EQ(rays(counters, RayKind::reflection), 1u);
}

std::string glass_pane(const std::string& more) {
  return more +
         "<surface type='Box'><minPt>-99 -99 -1</minPt><maxPt>99 99 0</maxPt><shader "
         "type='Glass'><refractiveIndex>1.5</refractiveIndex></shader></surface>";
}

TEST(Glass, IsLeftByTheOtherSideWithTheIndicesSwapped) {
  // Straight down through the pane to a wall that a light between pane and wall makes white: 0.96 in, 0.96 out. Of the
  // mirror images inside, the first (0.96 * 0.04) is followed and leaves upwards; the second is below the minimum.
  const ReadScene read =
      scene_of(glass_pane("<light><position>0 0 -2</position></light><surface type='Box'><minPt>-9 -9 "
                          "-4</minPt><maxPt>9 9 -3</maxPt></surface>"));
  TraceCounters counters;
  const Color color = traced(read.scene, {{0, 0, 3}, {0, 0, -1}}, &counters);
  EXPECT_NEAR(color.g, 0.96 * 0.96, 1e-15);
  EXPECT_EQ(counters.rays, (std::array<std::uint64_t, kRayKinds>{1, 2, 3, 1}));
}

TEST(Glass, RefractedRayIsShiftedBySnellsLaw) {
  // At sin = 0.6 outside, sin = 0.4 inside: crossing the pane moves the ray by 0.4 / sqrt(1 - 0.16), then it goes on as
  // before. It comes out at x = 0.436, one below at x = 0.436 + 0.75 = 1.186: a ball of radius 0.01 there is met.
  const double x = 0.4 / std::sqrt(0.84) + 0.75;
  const auto looking = [&](double at) {
    return traced(scene_of(glass_pane("<light><position>" + std::to_string(at) +
                                      " 0 -1.5</position></light><surface type='Sphere'><center>" + std::to_string(at) +
                                      " 0 -2</center><radius>.01</radius></surface>"))
                      .scene,
                  {{-0.6, 0, 0.8}, {0.6, 0, -0.8}});
  };
  EXPECT_GT(looking(x).g, 0.1);
  EXPECT_EQ(looking(x + 0.05).g, 0);
  EXPECT_EQ(looking(x - 0.05).g, 0);
}

TEST(Glass, ReflectsAllBeyondTheCriticalAngle) {
  // From inside at a cosine of 0.6, beyond the critical one of 0.745: mirror images of weight 1 and no others.
  TraceCounters counters;
  traced(scene_of(glass_pane("")).scene, {{0, 0, -0.5}, {0.8, 0, 0.6}}, &counters);
  EXPECT_EQ(counters.rays, (std::array<std::uint64_t, kRayKinds>{1, 11, 0, 0}));
  traced(scene_of(glass_pane("<maxDepth>3</maxDepth>")).scene, {{0, 0, -0.5}, {0.8, 0, 0.6}}, &counters);
  EXPECT_EQ(counters.rays, (std::array<std::uint64_t, kRayKinds>{1, 2, 0, 0}));
}

TEST(Glass, SchlicksRuleIsTakenWhereItIsAskedFor) {
  // At a cosine of 1/2 outside, exact R = 0.0892 and Schlick's 0.07; straight below the white wall.
  const std::string elements = glass_pane(
      "<minContribution>.2</minContribution><light><position>1 0 5</position></light>"
      "<surface type='Sphere'><center>1.7320508 0 2</center><radius>.25</radius></surface>");
  const Ray ray{{-1.7320508075688772, 0, 1}, {1.7320508075688772, 0, -1}};
  BuildOptions schlick;
  schlick.fresnel = Fresnel::schlick;
  const auto first_share = [&](const BuildOptions& options, const std::string& minimum) {
    BuildOptions with_minimum = options;
    with_minimum.overrides.min_contribution = std::stod(minimum);
    TraceCounters counters;
    traced(scene_of(elements, with_minimum).scene, ray, &counters);
    return rays(counters, RayKind::reflection) > 0;
  };
  EXPECT_TRUE(first_share({}, "0.089"));
  EXPECT_FALSE(first_share({}, "0.09"));
  EXPECT_TRUE(first_share(schlick, "0.0699"));
  EXPECT_FALSE(first_share(schlick, "0.0701"));
}

}  // namespace
}  // namespace plumb

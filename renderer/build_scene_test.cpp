#include "renderer/build_scene.h"

#include <gtest/gtest.h>

#include "renderer/scene_for_tests.h"

namespace plumb {
namespace {

/// Where the origin of a placed surface's frame stands in the world.
Point3 place(const Scene& scene, std::size_t index) { return scene.placed().at(index).world_from_object(Point3{}); }

Color seen_along_z(const Scene& scene, double x) { return traced(scene, {{x, 0, 5}, {0, 0, -1}}); }

TEST(BuildScene, ASurfaceReferredToFromTwoGroupsIsMadeOnce) {
  const ReadScene read = scene_of(
      "<surface type='Group'><translate>1 0 0</translate><surface type='Sphere' name='ball'/></surface>"
      "<surface type='Group'><translate>-1 0 0</translate><surface ref='ball'/><surface type='Sphere'/></surface>");
  ASSERT_EQ(read.scene.placed().size(), 3u);
  EXPECT_EQ(read.scene.placed()[0].surface, read.scene.placed()[1].surface);
  EXPECT_NE(read.scene.placed()[0].surface, read.scene.placed()[2].surface);
  EXPECT_EQ(place(read.scene, 0), (Point3{1, 0, 0}));
  EXPECT_EQ(place(read.scene, 1), (Point3{-1, 0, 0}));
}

TEST(BuildScene, AGroupReferredToTwiceSharesItsMembers) {
  const ReadScene read = scene_of(
      "<surface type='Group' name='pair'><surface type='Sphere'/><surface type='Box'/></surface>"
      "<surface type='Group'><scale>2 2 2</scale><surface ref='pair'/><surface ref='pair'/></surface>");
  const auto& placed = read.scene.placed();
  ASSERT_EQ(placed.size(), 6u);
  EXPECT_EQ(placed[0].surface, placed[2].surface);
  EXPECT_EQ(placed[1].surface, placed[5].surface);
}

TEST(BuildScene, TransformsMultiplyInFileOrderTheFirstOutermost) {
  // Scale, then move: the point 0 goes to 1 and then to 2.
  EXPECT_EQ(place(scene_of("<surface type='Group'><scale>2 2 2</scale><translate>1 0 0</translate><surface "
                           "type='Sphere'/></surface>")
                      .scene,
                  0),
            (Point3{2, 0, 0}));
  EXPECT_EQ(place(scene_of("<surface type='Group'><translate>1 0 0</translate><scale>2 2 2</scale><surface "
                           "type='Sphere'/></surface>")
                      .scene,
                  0),
            (Point3{1, 0, 0}));
  // Two of a kind both count: a turn about z takes (1,0,0) to (0,1,0), then comes the first move.
  EXPECT_EQ(place(scene_of("<surface type='Group'><translate>5 0 0</translate><rotate>0 0 90</rotate><translate>1 0 "
                           "0</translate><surface type='Sphere'/></surface>")
                      .scene,
                  0),
            (Point3{5, 1, 0}));
}

TEST(BuildScene, AllTransformsOfAGroupApplyToAllMembersWhereverTheyStand) {
  const ReadScene read = scene_of(
      "<surface type='Group'><surface type='Sphere'/><scale>2 2 2</scale><surface type='Sphere'/><translate>1 0 "
      "0</translate><surface type='Sphere'/></surface>");
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(place(read.scene, i), (Point3{2, 0, 0})) << i;
}

TEST(BuildScene, NestedGroupsMultiplyParentTimesOwn) {
  const ReadScene read = scene_of(
      "<surface type='Group'><rotate>0 0 90</rotate><surface type='Group'><translate>1 2 0</translate><surface "
      "type='Sphere'/></surface><surface type='Sphere'/></surface>");
  EXPECT_EQ(place(read.scene, 0), (Point3{-2, 1, 0}));
  EXPECT_EQ(place(read.scene, 1), (Point3{0, 0, 0})) << "the inner group's transform ends with it";
}

TEST(BuildScene, ANegativeScaleIsNoError) {
  EXPECT_EQ(
      scene_of("<surface type='Group'><scale>-1 1 1</scale><surface type='Sphere'/></surface>").scene.placed().size(),
      1u);
}

TEST(BuildScene, AGroupsShaderAppliesToMembersThatHaveNone) {
  const auto lambertian = [](const std::string& color) {
    return "<shader type='Lambertian'><diffuseColor>" + color + "</diffuseColor></shader>";
  };
  const auto ball = [](const std::string& x, const std::string& more = "") {
    return "<surface type='Sphere'><center>" + x + " 0 0</center>" + more + "</surface>";
  };
  const ReadScene read =
      scene_of("<camera/><light><position>0 0 100</position></light>" + ball("0") + "<surface type='Group'>" +
               ball("3") + lambertian("1 0 0") + ball("6", lambertian("0 1 0")) + "<surface type='Group'>" + ball("9") +
               "</surface><surface type='Group'>" + lambertian("0 0 1") + ball("12") + "</surface></surface>");
  const auto hue = [&](double x) {
    const Color c = seen_along_z(read.scene, x);
    return Color{c.r > 0.5 ? 1.0 : c.r, c.g > 0.5 ? 1.0 : c.g, c.b > 0.5 ? 1.0 : c.b};
  };
  EXPECT_EQ(hue(0), (Color{1, 1, 1})) << "no shader anywhere: white Lambertian";
  EXPECT_EQ(hue(3), (Color{1, 0, 0})) << "the group's, though it stands after the member";
  EXPECT_EQ(hue(6), (Color{0, 1, 0})) << "its own";
  EXPECT_EQ(hue(9), (Color{1, 0, 0})) << "of the group around its group";
  EXPECT_EQ(hue(12), (Color{0, 0, 1})) << "of the innermost group";
}

TEST(BuildScene, ASharedSurfaceTakesTheShaderOfEachGroup) {
  const ReadScene read = scene_of(
      "<surface type='Group'><shader type='Phong' name='a'/><surface type='Sphere' name='b'/></surface>"
      "<surface type='Group'><shader type='Lambertian'/><surface ref='b'/></surface><surface type='Group'><shader "
      "ref='a'/><surface ref='b'/></surface>");
  const auto& placed = read.scene.placed();
  ASSERT_EQ(placed.size(), 3u);
  EXPECT_NE(placed[0].shader, placed[1].shader);
  EXPECT_EQ(placed[0].shader, placed[2].shader) << "a shader is made once, too";
}

TEST(BuildScene, DefaultsAndOverrides) {
  const ReadScene plain = scene_of("<image>30 20</image>");
  EXPECT_EQ(plain.scene.image_size(), (Size2{30, 20}));
  EXPECT_EQ(plain.scene.samples(), 1);
  EXPECT_EQ(plain.scene.max_depth(), 12);
  EXPECT_EQ(plain.scene.min_contribution(), 0.01);
  EXPECT_EQ(plain.scene.fresnel(), Fresnel::exact);
  EXPECT_TRUE(plain.warnings.empty());
  BuildOptions options;
  options.overrides = {.image_size = Size2{3, 4}, .samples = 9, .max_depth = 2, .min_contribution = 0.5};
  options.fresnel = Fresnel::schlick;
  const ReadScene changed = scene_of("<image>30 20</image><samples>4</samples><maxDepth>7</maxDepth>", options);
  EXPECT_EQ(changed.scene.image_size(), (Size2{3, 4}));
  EXPECT_EQ(changed.scene.samples(), 9);
  EXPECT_EQ(changed.scene.max_depth(), 2);
  EXPECT_EQ(changed.scene.min_contribution(), 0.5);
  EXPECT_EQ(changed.scene.fresnel(), Fresnel::schlick);
}

TEST(BuildScene, RendererKindsHaveUniqueNamesAndSoundTables) {
  const KindTable table = renderer_kinds(Dialect::pa3_2011);
  int parameters = 0;
  for (const Kind* kind : table.kinds) {
    EXPECT_EQ(table.find(kind->role, kind->name), kind);
    EXPECT_FALSE(kind->meaning.empty()) << kind->name;
    for (const Parameter& parameter : kind->parameters) {
      EXPECT_FALSE(parameter.meaning.empty()) << kind->name << " " << parameter.name;
      if (parameter.presence == Presence::defaulted) {
        EXPECT_NO_THROW(parse_value(parameter, parameter.default_text, {})) << kind->name << " " << parameter.name;
      }
      ++parameters;
    }
  }
  EXPECT_EQ(table.kinds.size(), 11u) << "5 surfaces, 4 shaders, a light and a camera";
  EXPECT_GT(parameters, 25);
}

}  // namespace
}  // namespace plumb

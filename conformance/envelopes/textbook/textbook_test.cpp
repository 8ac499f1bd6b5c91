#include "conformance/envelopes/textbook/textbook.h"

#include <map>
#include <set>

#include "conformance/envelopes/textbook/agreement_for_tests.h"
#include "meshes/formats/write_msh.h"
#include "meshes/generators/icosphere.h"

namespace plumb {
namespace {

/// Every kind of element, in and out of groups: what the library lacks too.
std::filesystem::path everything() {
  TriangleMesh ball = icosphere(2);
  ball.normals.clear();
  write_msh(ball, scene_test_file("flat.msh"));
  for (const Point3& p : ball.positions) ball.normals.push_back({p.x, p.y, p.z});
  write_msh(ball, scene_test_file("smooth.msh"));
  return write_scene_test_file("everything.xml", R"(<scene>
    <image>120 90</image><samples>4</samples>
    <camera><viewPoint>1 3 9</viewPoint><viewDir>-1 -2.5 -9</viewDir><projNormal>0.1 0.3 1</projNormal>
      <projDistance>2</projDistance><viewWidth>2</viewWidth><viewHeight>1.5</viewHeight></camera>
    <light><position>4 7 6</position><color>.7 .6 .5</color></light>
    <light><position>-5 4 3</position><intensity>.3 .3 .5</intensity></light>
    <shader name="glaze" type="Glazed"><refractiveIndex>1.6</refractiveIndex>
      <substrate type="Phong"><diffuseColor>.5 .3 .2</diffuseColor><exponent>12</exponent></substrate></shader>
    <shader name="glass" type="Glass"><refractiveIndex>1.5</refractiveIndex></shader>
    <surface type="Box"><minPt>-5 -1.5 -5</minPt><maxPt>5 -1 4</maxPt></surface>
    <surface type="Group"><translate>-2.6 0 -1</translate><rotate>25 -40 10</rotate><scale>.8 .9 1.1</scale>
      <surface name="cone" type="Cone"><center>0 0 .4</center><radius>.5</radius><height>2</height>
        <shader type="Phong"><diffuseColor>.2 .6 .3</diffuseColor><exponent>20</exponent></shader></surface></surface>
    <surface type="Group"><shader ref="glaze"/><rotate>0 30 0</rotate>
      <surface type="Group"><translate>1.2 .1 -2</translate><scale>1 .6 -1</scale><rotate>70 0 20</rotate>
        <surface type="Cylinder"><radius>.8</radius><height>2.2</height></surface></surface>
      <surface type="Sphere"><center>-.7 -.2 .3</center><radius>.7</radius></surface></surface>
    <surface type="Group"><translate>2.4 -.1 .7</translate><rotate>10 20 30</rotate>
      <surface type="Mesh"><data>smooth.msh</data><shader ref="glass"/></surface></surface>
    <surface type="Group"><translate>-2.2 -.4 2</translate><scale>.6 .6 .6</scale>
      <surface type="Mesh"><data>flat.msh</data></surface></surface>
    <surface type="Group"><translate>.6 -.5 3</translate><scale>.4 .4 .4</scale><surface ref="cone"/></surface>
    <surface type="Box"><minPt>.2 1.2 -1</minPt><maxPt>1.4 2 -1.1</maxPt></surface>
  </scene>)");
}

Image rendered(const std::filesystem::path& file, const BuildOptions& options = {}) {
  return render(read_and_build(file, options).scene, {}).image;
}

TEST(Textbook, AgreesWithTheRendererOnEveryKindOfElement) {
  const TextbookScene scene(everything());
  EXPECT_EQ(scene.options.grid, 2);
  std::map<std::uint32_t, int> seen;
  const auto samples = scene.samples(scene.options);
  for (const TextbookSample& sample : samples) ++seen[sample.primary];
  EXPECT_EQ(seen.size(), 9u) << "each of eight surfaces, and nothing";
  for (const auto& [surface, count] : seen) EXPECT_GT(count, 200) << surface;
  EXPECT_LE(pixels_apart(textbook_picture(samples, scene.options), rendered(everything())), 3);  // none was seen
}

TEST(Textbook, AgreesOnEachVariantToo) {
  const TextbookScene scene(everything());
  BuildOptions deep;
  deep.overrides.max_depth = 3, deep.overrides.min_contribution = 0, deep.overrides.samples = 9;
  deep.overrides.image_size = Size2{70, 80};
  deep.fresnel = Fresnel::schlick;
  const TextbookOptions options = scene.with([](TextbookOptions& o) {
    o.max_depth = 3, o.min_contribution = 0, o.grid = 3, o.width = 70, o.height = 80, o.schlick = true;
  });
  EXPECT_LE(pixels_apart(scene.picture(options), rendered(everything(), deep)), 3);
}

TEST(Textbook, AgreementIsLostByEachMistake) {
  const TextbookScene scene(everything());
  const Image expected = rendered(everything());
  using Change = void (*)(TextbookOptions&);
  const std::pair<const char*, Change> mistakes[] = {
      {"Schlick", [](TextbookOptions& o) { o.schlick = true; }},
      {"depth", [](TextbookOptions& o) { o.max_depth = 2; }},
      {"contribution", [](TextbookOptions& o) { o.min_contribution = 0.1; }},
      {"half a pixel to the right", [](TextbookOptions& o) { o.shift_x = 0.5; }},
      {"half a pixel up", [](TextbookOptions& o) { o.shift_y = 0.5; }},
      {"one sample", [](TextbookOptions& o) { o.grid = 1; }},
      {"offset", [](TextbookOptions& o) { o.t_min = 0.1; }},
      {"vertices", [](TextbookOptions& o) { o.vertex_noise = 1e-3; }},
      {"acne", [](TextbookOptions& o) { o.single = true, o.t_min = 1e-9; }},
  };
  int found = 0;
  for (const auto& [name, change] : mistakes) {
    const Image wrong = scene.picture(scene.with(change));
    EXPECT_GT(pixels_apart_by_levels(levels_of(wrong), levels_of(expected), 0), 100) << name;
    ++found;
  }
  EXPECT_EQ(found, 9);
}

TEST(Textbook, SamplesDoNotDependOnTheThreads) {
  const TextbookScene scene(everything());
  int compared = 0;
  for (const bool single : {false, true}) {
    const TextbookOptions options = scene.with([&](TextbookOptions& o) { o.single = single; });
    const auto one = scene.samples(options, 1);
    EXPECT_EQ(one.size(), 120u * 90u * 4u);
    EXPECT_EQ(scene.samples(options, 1), one);
    EXPECT_EQ(scene.samples(options, 3), one);
    ++compared;
  }
  EXPECT_EQ(compared, 2);
}

/// A ball before a wall, a light at the right of the eye. Four samples a pixel, the wall fills the picture but for its
/// uppermost rows.
TextbookScene ball_before_wall(const std::string& ball) {
  return TextbookScene(write_scene_test_file("ball.xml", R"(<scene><image>8 8</image><samples>4</samples>
      <camera><viewPoint>0 0 6</viewPoint></camera><light><position>4 0 6</position></light>
      <surface type="Sphere">)" + ball + R"(</surface>
      <surface type="Box"><minPt>-9 -9 -3</minPt><maxPt>9 3 -2</maxPt></surface></scene>)"));
}

TEST(Textbook, SamplesSayWhatTheySaw) {
  const TextbookScene scene = ball_before_wall("");
  const auto samples = scene.samples(scene.options);
  // x from the left and y from the top, in samples.
  const auto at = [&](std::size_t x, std::size_t y) {
    return samples[((y / 2 * 8 + x / 2) * 2 + (1 - y % 2)) * 2 + x % 2];
  };
  EXPECT_EQ(at(8, 8).primary, 1u);
  EXPECT_EQ(at(8, 8).face, 0u);
  EXPECT_EQ(at(0, 8).primary, 2u);
  EXPECT_EQ(at(0, 8).face, 5u) << "the maximal one in z";
  EXPECT_EQ(at(0, 0).primary, 0u) << "above the wall";
  EXPECT_EQ(at(0, 0).color, Color{});
  EXPECT_EQ(at(0, 0).grazing, 1);
  EXPECT_NE(at(8, 8).shadows, 0u) << "lit";
  EXPECT_EQ(at(15, 8).shadows, at(8, 8).shadows) << "by the same light";
  // The ball's shadow falls to the left: from (4,0,6) past (0,0,0) to (-1.33,0,-2), and a ball's radius around it.
  // There x is 8 (u - 0.5), of sample 4 -1.75; the ball itself hides those from 5 on.
  EXPECT_EQ(at(4, 8).primary, 2u);
  EXPECT_EQ(at(4, 8).shadows, 0u);
  EXPECT_EQ(at(4, 8).color, Color{});
  for (const TextbookSample& sample : samples) EXPECT_EQ(sample.path, 0u) << "nothing is reflected";
}

TEST(Textbook, PathsTellRaysApart) {
  const TextbookScene scene = ball_before_wall("<shader type='Glass'><refractiveIndex>1.5</refractiveIndex></shader>");
  std::set<std::uint32_t> paths;
  int through_glass = 0;
  for (const TextbookSample& sample : scene.samples(scene.options)) {
    if (sample.primary != 1) continue;
    ++through_glass;
    EXPECT_NE(sample.path, 0u);
    EXPECT_LT(sample.grazing, 1);
    paths.insert(sample.path);
  }
  EXPECT_GT(through_glass, 10);
  EXPECT_GT(paths.size(), 1u);
  EXPECT_LT(paths.size(), static_cast<std::size_t>(through_glass)) << "neighbours take the same way";
}

TEST(Textbook, NoiseMovesWhatItIsMeantTo) {
  const TextbookScene scene(everything());
  const auto at = [&](double noise) {
    return scene.picture(scene.with([&](TextbookOptions& o) { o.vertex_noise = noise; }));
  };
  const Image usual = at(0);
  EXPECT_EQ(pixels_apart(at(1e-6), at(1e-6), 0), 0) << "the same each time";
  EXPECT_GT(pixels_apart(usual, at(1e-6), 0), 5000);
  EXPECT_LT(pixels_apart_by_levels(levels_of(usual), levels_of(at(1e-6)), 2), 20);
}

TEST(Textbook, PictureIsTheMeanOfItsSamples) {
  const TextbookOptions options{.grid = 2, .width = 1, .height = 1};
  std::vector<TextbookSample> samples(4);
  for (std::size_t i = 0; i < 4; ++i) samples[i].color = {static_cast<double>(i), 1, 0};
  EXPECT_EQ(textbook_picture(samples, options).at(0, 0), (Color{1.5, 1, 0}));
}

TEST(Textbook, RefusesPicturesWithoutPixelsOrSamples) {
  const TextbookScene scene = ball_before_wall("");
  using Change = void (*)(TextbookOptions&);
  const Change changes[] = {[](TextbookOptions& o) { o.width = 0; }, [](TextbookOptions& o) { o.height = -1; },
                            [](TextbookOptions& o) { o.grid = 0; }};
  for (const Change& change : changes) EXPECT_THROW(scene.samples(scene.with(change)), std::invalid_argument);
}

TEST(Textbook, RefusesATransformThatFloatsCannotInvert) {
  const TextbookScene scene(write_scene_test_file("tiny.xml", R"(<scene><image>2 2</image>
<surface type="Group"><scale>1e-16 1e-16 1e-16</scale><surface type="Sphere"/></surface></scene>)"));
  EXPECT_EQ(scene.samples(scene.options).size(), 4u);
  try {
    scene.samples(scene.with([](TextbookOptions& o) { o.single = true; }));
    FAIL() << "1e-48 is zero in single precision";
  } catch (const InputError& error) {
    EXPECT_EQ(error.where().line, 2);
    EXPECT_NE(std::string(error.what()).find("no inverse"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace plumb

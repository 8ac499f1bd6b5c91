#include <gmock/gmock.h>
#include <stdlib.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "conformance/subject/probe_subject.h"
#include "conformance/subject/scene_file.h"
#include "renderer/build_scene.h"
#include "renderer/film/render.h"
#include "renderer/kinds.h"
#include "renderer/math/frame.h"
#include "renderer/shaders/fresnel.h"
#include "scenes/load_meshes.h"
#include "scenes/read_scene.h"

namespace plumb {
namespace {

/// `plumb probe` as any other program, held against the renderer that it is made of.
class ProbeCommandTest : public testing::Test {
 protected:
  ProbeCommandTest() {
    std::string name = (std::filesystem::temp_directory_path() / "plumb-probe-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder for the test");
    folder_ = name;
  }
  ~ProbeCommandTest() override { std::filesystem::remove_all(folder_); }

  static ProbeCommand command() { return {.arguments = {PLUMB_PROGRAM, "probe"}, .folder = "/", .environment = {}}; }

  static Scene built(const std::filesystem::path& file) {
    const SceneDescription description = read_scene(file, renderer_kinds(Dialect::pa3_2011));
    std::vector<std::string> warnings;
    return build_scene(description, load_meshes(description), {}, warnings);
  }
  Scene built(const SubjectScene& scene) const { return built(write_scene_file(scene, folder_)); }

  std::filesystem::path folder_;
};

TransformStep translate(double x, double y, double z) { return {TransformStep::Kind::translate, {x, y, z}}; }
TransformStep rotate(double x, double y, double z) { return {TransformStep::Kind::rotate, {x, y, z}}; }
TransformStep scale(double x, double y, double z) { return {TransformStep::Kind::scale, {x, y, z}}; }

/// One of each shape, at different depths of groups, mirrored and stretched.
SubjectScene nested_groups() {
  SubjectScene scene(6);
  scene[0].shape.kind = ShapeKind::sphere;
  scene[0].groups = {{translate(0.1, -0.2, 1.0 / 3), rotate(10, 20, 30)}, {scale(2, 0.5, 1.5), translate(0, 1, 0)}};
  scene[1].shape.kind = ShapeKind::box;
  scene[1].shape.min = {-0.5, -1, -0.25};
  scene[1].shape.max = {1, 0.5, 0.75};
  scene[1].groups = {{translate(-2, 0.3, 0)}, {rotate(0, 90, 45)}, {scale(1, -1, 2), rotate(33, 0, 0)}};
  scene[2].shape.kind = ShapeKind::cylinder;
  scene[2].shape.center = {0.25, 0, 0.5};
  scene[2].shape.radius = 0.7;
  scene[2].shape.height = 2;
  scene[2].groups = {{translate(2, 1, -1), rotate(70, -20, 5)}};
  scene[3].shape.kind = ShapeKind::cone;
  scene[3].shape.tip_z = 1.5;
  scene[3].groups = {{translate(1, -2, 0)}, {}};
  const TriangleMesh tetrahedron{
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}, {}, {}};
  scene[4].shape.kind = ShapeKind::mesh;
  scene[4].shape.mesh = std::make_shared<const TriangleMesh>(tetrahedron);
  scene[4].groups = {{scale(3, 2, 1), rotate(5, 6, 7)}, {translate(-1, -1, 0.5)}};
  scene[5].shape.kind = ShapeKind::triangle;
  scene[5].shape.vertices = {{{-3, -3, -3}, {3, -3, -3}, {0, 3, -3}}};
  return scene;
}

std::vector<Ray> random_rays(int count) {
  std::mt19937_64 random(20240609);
  std::uniform_real_distribution<double> uniform(-3, 3);
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i) {
    const Point3 from{2 * uniform(random), 2 * uniform(random), 2 * uniform(random)};
    const Point3 to{uniform(random), uniform(random), uniform(random)};
    rays.push_back({from, to - from});
    if (i % 3 == 0) rays.back().t_max = 1.25;
    if (i % 5 == 0) rays.back().direction.x = -0.0;
  }
  return rays;
}

/// The renderer's own closest hit, all its numbers.
void expect_same_hit(const Scene& scene, const Ray& ray, const SubjectHit& hit) {
  TraceCounters counters;
  const auto own = scene.closest_hit(ray, counters);
  ASSERT_EQ(hit.hit(), own.has_value());
  if (!own) return;
  EXPECT_EQ(hit.surface, own->placed);
  EXPECT_EQ(hit.t, own->hit.t);
  ASSERT_TRUE(hit.normal);
  EXPECT_EQ(as_normal(*hit.normal), scene.shading_point(ray, *own).normal);
  EXPECT_EQ(hit.has_weights, hit.surface >= 4);
  if (!hit.has_weights) return;
  EXPECT_EQ(hit.primitive, own->hit.part);
  EXPECT_EQ(hit.u, own->hit.u);
  EXPECT_EQ(hit.v, own->hit.v);
}

TEST_F(ProbeCommandTest, HitsAreTheRenderersOwn) {
  const Scene scene = built(nested_groups());
  ProbeSubject probe(command());
  EXPECT_EQ(probe.name(), "plumb");
  EXPECT_EQ(to_string(probe.contract()),
            "double in, double t, edges watertight, range closed, from inside hits the exit, meshes in float");
  probe.load(nested_groups());
  // More than one question's worth.
  const std::vector<Ray> rays = random_rays(21'000);
  const std::vector<SubjectHit> hits = probe.closest(rays);
  ASSERT_EQ(hits.size(), rays.size());
  std::vector<int> count(7, 0);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    expect_same_hit(scene, rays[i], hits[i]);
    ++count[hits[i].hit() ? hits[i].surface : 6];
  }
  for (const int surface : count) EXPECT_GT(surface, 100) << "each surface, and none, was met";
}

TEST_F(ProbeCommandTest, AnyAndAllAgreeWithClosest) {
  ProbeSubject probe(command());
  probe.load(nested_groups());
  std::vector<Ray> rays = random_rays(1500);
  const std::vector<SubjectHit> closest = probe.closest(rays);
  const std::vector<std::uint8_t> any = probe.any(rays);
  const std::vector<std::vector<SubjectHit>> all = probe.all(rays);
  ASSERT_EQ(any.size(), rays.size());
  ASSERT_EQ(all.size(), rays.size());
  int crossings_of_solids = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    EXPECT_EQ(any[i], closest[i].hit());
    EXPECT_EQ(all[i].empty(), !closest[i].hit());
    double first = INFINITY;
    int of_solids = 0;
    for (const SubjectHit& hit : all[i]) {
      first = std::min(first, hit.t);
      of_solids += hit.surface != 5;
    }
    EXPECT_EQ(first, closest[i].hit() ? closest[i].t : INFINITY);
    crossings_of_solids += of_solids;
  }
  EXPECT_GT(crossings_of_solids, 1000);

  // From outside to outside, a closed surface is crossed an even number of times.
  for (Ray& ray : rays) ray = {ray.origin + -100 * ray.direction, ray.direction};
  for (const auto& hits : probe.all(rays)) {
    std::vector<int> crossings(6, 0);
    for (const SubjectHit& hit : hits) ++crossings[hit.surface];
    for (int surface = 0; surface < 5; ++surface) EXPECT_EQ(crossings[static_cast<std::size_t>(surface)] % 2, 0);
  }
}

TEST_F(ProbeCommandTest, BoxesAndMatricesAreTheRenderersOwn) {
  const Scene scene = built(nested_groups());
  ProbeSubject probe(command());
  probe.load(nested_groups());
  const std::vector<Bounds3> bounds = probe.bounds();
  const std::vector<SubjectMatrices> matrices = probe.matrices();
  const std::vector<Point3> positions = probe.average_positions();
  ASSERT_EQ(bounds.size(), 6u);
  ASSERT_EQ(matrices.size(), 6u);
  ASSERT_EQ(positions.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    const PlacedSurface& placed = scene.placed()[i];
    EXPECT_EQ(bounds[i], placed.surface->world_bounds(placed.world_from_object));
    EXPECT_EQ(matrices[i].world_from_object, placed.world_from_object.matrix());
    EXPECT_EQ(matrices[i].inverse, placed.world_from_object.inverse_matrix());
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t column = 0; column < 3; ++column)
        EXPECT_EQ(matrices[i].inverse_transpose[row][column], matrices[i].inverse[column][row]);
    EXPECT_TRUE(bounds[i].contains(positions[i]));
  }
}

TEST_F(ProbeCommandTest, AnswersOptics) {
  ProbeSubject probe(command());
  EXPECT_EQ(probe.fresnel(0.5, 1, 1.5), reflectance({0.5, 1, 1.5}, Fresnel::exact));
  EXPECT_EQ(probe.fresnel(0.1, 1.5, 1), 1);
  const Vec3 direction = normalized(Vec3{1, 0, -1});
  const auto refracted = probe.refract(direction, {0, 0, 1}, 1, 1.5);
  ASSERT_TRUE(refracted);
  EXPECT_NEAR(refracted->x, direction.x / 1.5, 4 * 0x1p-53);
  EXPECT_NEAR(length(*refracted), 1, 4 * 0x1p-53);
  EXPECT_EQ(probe.refract(direction, {0, 0, -1}, 1, 1.5), refracted) << "either side of the normal";
  EXPECT_FALSE(probe.refract(direction, {0, 0, 1}, 1.5, 1));
  EXPECT_EQ(probe.frame({0, -0.0, -2}), frame_about({0, -0.0, -2}));
}

TEST_F(ProbeCommandTest, TracesThePixelsOfAPicture) {
  const std::filesystem::path file = std::filesystem::path(PLUMB_SOURCE_DIR) / "scenes/library/groups.xml";
  const Scene scene = built(file);
  ProbeSubject probe(command());
  probe.load_file(file);
  ASSERT_TRUE(probe.can_trace());
  const std::vector<std::array<int, 2>> pixels{{0, 0}, {100, 75}, {199, 149}, {60, 90}, {130, 60}};
  const std::vector<Color> colors = probe.trace(pixels);
  ASSERT_EQ(colors.size(), pixels.size());
  int coloured = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const PixelRect crop{pixels[i][0], pixels[i][1], 1, 1};
    EXPECT_EQ(colors[i], render(scene, {.threads = 1, .crop = crop, .progress = {}}).image.at(0, 0));
    coloured += colors[i] != Color{};
  }
  EXPECT_GE(coloured, 2);
}

TEST_F(ProbeCommandTest, AnswersOnStandardOutputWithoutAPrivateLine) {
  for (const char* line : {"unset PLUMB_PROBE_FD", "PLUMB_PROBE_FD=x", "PLUMB_PROBE_FD=99", "exec 3</dev/null"}) {
    ProbeCommand fallback = command();
    fallback.arguments = {"/bin/sh", "-c", std::string(line) + "; echo a log; exec " PLUMB_PROGRAM " probe"};
    ProbeSubject probe(fallback);
    probe.load(nested_groups());
    EXPECT_EQ(probe.closest(random_rays(10)).size(), 10u) << line;
  }
}

TEST_F(ProbeCommandTest, SaysWhatIsWrongWithAScene) {
  std::ofstream(folder_ / "wrong.xml") << "<scene>";
  ProbeSubject probe(command());
  try {
    probe.load_file(folder_ / "wrong.xml");
    ADD_FAILURE() << "it was loaded";
  } catch (const SubjectFailure& failure) {
    EXPECT_EQ(failure.cause(), "error");
    EXPECT_THAT(failure.what(), testing::HasSubstr("wrong.xml"));
  }
  probe.load(nested_groups());
  EXPECT_EQ(probe.bounds().size(), 6u);
}

TEST_F(ProbeCommandTest, LoadsManySmallScenes) {
  std::vector<Subject::Small> questions(300);
  for (Subject::Small& question : questions) {
    question.scene.resize(1);
    question.scene[0].shape.kind = ShapeKind::triangle;
    question.scene[0].shape.vertices = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    question.rays = {{{0.25, 0.25, 1}, {0, 0, -1}}};
  }
  ProbeSubject probe(command());
  const auto answers = probe.closest_each(questions);
  ASSERT_EQ(answers.size(), questions.size());
  for (const auto& hits : answers) {
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_EQ(hits[0].t, 1);
    EXPECT_EQ(hits[0].u, 0.25);
  }
}

}  // namespace
}  // namespace plumb

#include <gmock/gmock.h>

#include "meshes/read_mesh.h"
#include "renderer/image/read_picture.h"
#include "renderer/scene_for_tests.h"

// The course's own scenes against the course's own pictures. They are other people's data: nothing of them is stored
// here.

namespace plumb {
namespace {

struct Course {
  const char* scene;
  Fresnel fresnel;
  /// Linear search over the scene's large meshes is slow; smaller pictures do for comparing.
  std::optional<Size2> linear_size;
};

void PrintTo(const Course& course, std::ostream* out) { *out << course.scene; }

constexpr Size2 kSmall{40, 40};

const Course kScenes[] = {
    {"pa3-2011/Test4-glazed", Fresnel::exact, kSmall},
    {"pa3-2011/bunny10k_norms", Fresnel::exact, kSmall},
    {"pa3-2011/bunny500", Fresnel::exact, Size2{150, 150}},
    {"pa3-2011/bunny500_norms", Fresnel::exact, Size2{150, 150}},
    {"pa3-2011/bunny500_norms_aa", Fresnel::exact, kSmall},
    {"pa3-2011/glass-ball", Fresnel::exact, {}},
    {"pa3-2011/glazed-ball", Fresnel::exact, {}},
    {"pa3-2011/solids", Fresnel::exact, {}},
    {"pa3-2011/sphereMeshSquished", Fresnel::exact, kSmall},
    {"pa3-2011/sphereSquished", Fresnel::exact, {}},
    {"cs461-2012/bunny_norms_aa", Fresnel::schlick, kSmall},
    {"cs461-2012/one-blue-cylinder", Fresnel::schlick, {}},
    {"cs461-2012/one-sphere", Fresnel::schlick, {}},
    {"cs461-2012/wire-box-3", Fresnel::schlick, {}},
};

std::string file_of(const Course& course) { return std::string(PLUMB_SHARED_DIR "/course/") + course.scene + ".xml"; }

Image rendered(const Course& course, Accel accel, std::optional<Size2> size, int threads) {
  const ReadScene read = read_and_build(
      file_of(course), {.overrides = {.image_size = size, .samples = {}, .max_depth = {}, .min_contribution = {}},
                        .fresnel = course.fresnel,
                        .accel = accel});
  return render(read.scene, {.threads = threads, .crop = {}, .progress = {}}).image;
}

class CoursePicture : public ::testing::TestWithParam<Course> {};

TEST_P(CoursePicture, HasNoDifferentSample) {
  const Picture expected = read_picture(file_of(GetParam()) + ".soln.png");
  const Image image = rendered(GetParam(), Accel::bvh8, {}, 0);
  ASSERT_EQ(image.width(), expected.width);
  ASSERT_EQ(image.height(), expected.height);
  const std::vector<std::uint8_t> levels = levels_of(image);
  ASSERT_EQ(levels.size(), expected.samples.size());
  std::size_t different = 0, lit = 0;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    different += static_cast<float>(levels[i]) != expected.samples[i];
    lit += levels[i] > 0;
  }
  EXPECT_EQ(different, 0u);
  EXPECT_GT(lit, levels.size() / 100);
}

TEST_P(CoursePicture, IsTheSameByAnySearchAndOnAnyNumberOfThreads) {
  const Image linear = rendered(GetParam(), Accel::linear, GetParam().linear_size, 2);
  for (const Accel accel : {Accel::bvh2, Accel::bvh8}) {
    EXPECT_TRUE(same_bits(linear, rendered(GetParam(), accel, GetParam().linear_size, 2)));
    EXPECT_TRUE(same_bits(linear, rendered(GetParam(), accel, GetParam().linear_size, 1)));
  }
}

INSTANTIATE_TEST_SUITE_P(Courses, CoursePicture, ::testing::ValuesIn(kScenes), [](const auto& row) {
  std::string name;
  for (const char c : std::string(row.param.scene)) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
});

TEST(CoursePictures, MeshesInDoublePrecisionChangeOnePixelOfOneScene) {
  // The course stores meshes as floats. With the file's decimals as doubles, bunny500 has one pixel that is off.
  const SceneDescription description =
      read_scene(PLUMB_SHARED_DIR "/course/pa3-2011/bunny500.xml", renderer_kinds(Dialect::pa3_2011));
  MeshTable exact;
  for (const auto& [name, mesh] : load_meshes(description))
    exact[name] = std::make_shared<const TriangleMesh>(read_mesh(description.file.parent_path() / name));
  std::vector<std::string> warnings;
  const Scene scene = build_scene(description, exact, {}, warnings);
  const std::vector<std::uint8_t> levels = levels_of(render(scene, {}).image);
  const Picture expected = read_picture(description.file.string() + ".soln.png");
  int different_pixels = 0;
  for (std::size_t i = 0; i < levels.size(); i += 3) {
    bool same = true;
    for (std::size_t k = 0; k < 3; ++k) same = same && static_cast<float>(levels[i + k]) == expected.samples[i + k];
    different_pixels += !same;
  }
  EXPECT_EQ(different_pixels, 1);
}

}  // namespace
}  // namespace plumb

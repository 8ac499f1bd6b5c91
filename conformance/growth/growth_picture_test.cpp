#include "conformance/growth/growth_picture.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "conformance/growth/growth_mesh.h"
#include "conformance/growth/growth_scene.h"
#include "meshes/formats/write_msh.h"
#include "renderer/build_scene.h"
#include "renderer/film/render.h"
#include "renderer/image/write_image.h"
#include "renderer/kinds.h"
#include "scenes/load_meshes.h"
#include "scenes/read_scene.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// The gate's own scene, seen in the first round, in any size.
class GrowthPicture : public testing::Test {
 protected:
  GrowthPicture() {
    std::string name = (fs::temp_directory_path() / "plumb-growth-picture-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder for the test");
    folder_ = name;
    write_msh(growth_mesh(1), folder_ / "mesh.msh");
  }
  ~GrowthPicture() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Scene scene(int side, int round = 0) const {
    std::ifstream stream(fs::path(PLUMB_SOURCE_DIR) / "suites/growth/mesh.xml");
    GrowthNames names = camera_names(growth_camera(GrowthView::oblique, round, 1), side, side);
    names["mesh"] = "mesh.msh";
    std::ofstream(folder_ / "scene.xml") << filled_template(std::string(std::istreambuf_iterator<char>(stream), {}),
                                                            names);
    const SceneDescription description = read_scene(folder_ / "scene.xml", renderer_kinds(dialect_named("pa3-2011")));
    std::vector<std::string> warnings;
    return build_scene(description, load_meshes(description), {}, warnings);
  }
  fs::path picture(const Image& image) const {
    write_image(image, folder_ / "picture.png");
    return folder_ / "picture.png";
  }
  static Image rendered(const Scene& scene) {
    return render(scene, {.threads = 1, .crop = {}, .progress = nullptr}).image;
  }
  std::string cause(const Image& image, const Scene& scene, const GrowthTolerance& tolerance = {}) const {
    return check_growth_picture(picture(image), scene, tolerance, 1).cause;
  }

  fs::path folder_;
};

TEST_F(GrowthPicture, PassesOneThatWasRendered) {
  for (const int side : {8, 50, 200}) EXPECT_EQ(cause(rendered(scene(side)), scene(side)), "") << side;
}

TEST_F(GrowthPicture, RefusesOneThatWasRenderedSmallerAndEnlarged) {
  for (const int factor : {2, 4}) {
    const Image small = rendered(scene(200 / factor));
    Image large(200, 200);
    for (int y = 0; y < 200; ++y)
      for (int x = 0; x < 200; ++x) large.at(x, y) = small.at(x / factor, y / factor);
    EXPECT_EQ(cause(large, scene(200)), "different") << factor;
    EXPECT_EQ(cause(small, scene(200)), "wrong_size") << factor;
  }
}

TEST_F(GrowthPicture, RefusesOneThatWasKeptFromAnotherRound) {
  EXPECT_EQ(cause(rendered(scene(100, 1)), scene(100, 0)), "different");
}

TEST_F(GrowthPicture, RefusesOneWithEveryTwentiethRowLeftOut) {
  Image image = rendered(scene(200));
  for (int y = 0; y < 200; y += 20)
    for (int x = 0; x < 200; ++x) image.at(x, y) = {};
  EXPECT_EQ(cause(image, scene(200)), "different");
}

}  // namespace
}  // namespace plumb

#include "scenes/moved_camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "renderer/math/input_error.h"

namespace plumb {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::filesystem::path scene_file(const std::string& text) {
  const auto file =
      std::filesystem::path(::testing::TempDir()) / ("moved_camera-" + std::to_string(::getpid()) + ".xml");
  std::ofstream(file) << text;
  return file;
}

const CameraPlace kPlace{{1, 2.5, -3}, {0.1, 0, -1}, {0, 1, 0}, std::nullopt};

TEST(MovedCamera, TakesThePlaceOfWhatStoodThere) {
  const std::string text =
      scene_with_camera(scene_file("<scene><!-- kept --><CAMERA><ViewPoint>9 9 9</ViewPoint><viewdir>7 7 7</viewdir>"
                                   "<projDistance>2</projDistance></CAMERA><image>4 3</image></scene>"),
                        kPlace);
  EXPECT_THAT(text, HasSubstr("<viewPoint>1 2.5 -3</viewPoint>"));
  EXPECT_THAT(text, HasSubstr("<viewDir>0.10000000000000001 0 -1</viewDir>"));
  EXPECT_THAT(text, HasSubstr("<viewUp>0 1 0</viewUp>"));
  EXPECT_THAT(text, HasSubstr("<projDistance>2</projDistance>"));
  EXPECT_THAT(text, HasSubstr("<!-- kept -->"));
  EXPECT_THAT(text, Not(HasSubstr("9 9 9")));
  EXPECT_THAT(text, Not(HasSubstr("7 7 7")));
  EXPECT_THAT(text, Not(HasSubstr("projNormal")));
}

TEST(MovedCamera, IsAddedWhereThereIsNone) {
  EXPECT_THAT(scene_with_camera(scene_file("<scene><image>4 3</image></scene>"), kPlace),
              HasSubstr("<camera>\n    <viewPoint>1 2.5 -3</viewPoint>"));
}

TEST(MovedCamera, RefusesWhatCannotBeMoved) {
  EXPECT_THROW(scene_with_camera(scene_file("<scene><camera ref='c'/></scene>"), kPlace), InputError);
  EXPECT_THROW(scene_with_camera(scene_file("<scene><camera/><camera/></scene>"), kPlace), InputError);
  EXPECT_THROW(scene_with_camera(scene_file("<scene>"), kPlace), InputError);
}

}  // namespace
}  // namespace plumb

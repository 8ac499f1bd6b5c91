#include "tools/developer/layers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace plumb {
namespace {

TEST(Layers, TheProjectKeepsToItsTable) {
  const LayersReport report = check_layers(PLUMB_SOURCE_DIR);
  EXPECT_THAT(report.faults, testing::IsEmpty());
  EXPECT_GT(report.includes, 500);
}

TEST(Layers, FaultyIncludesAreCaught) {
  EXPECT_NE(include_fault("reference/oracle.cpp", "renderer/scene.h", true), "");
  EXPECT_NE(include_fault("scenes/read_scene.cpp", "renderer/kinds.h", true), "");
  EXPECT_NE(include_fault("renderer/math/vec3.h", "renderer/scene.h", true), "");
  EXPECT_NE(include_fault("renderer/scene.cpp", "conformance/verdict.h", true), "");
  EXPECT_NE(include_fault("reports/table.cpp", "conformance/judge/grade.h", true), "");
  EXPECT_NE(include_fault("examples/x/tracer.cpp", "renderer/math/vec3.h", true), "");
  EXPECT_NE(include_fault("renderer/scene.cpp", "scene.h", true), "");
  EXPECT_NE(include_fault("renderer/scene.cpp", "OpenImageIO/imageio.h", false), "");
  EXPECT_NE(include_fault("renderer/math/transform.cpp", "mpfr.h", false), "");
  EXPECT_NE(include_fault("bench/race/arena.cpp", "embree3/rtcore.h", false), "");
}

TEST(Layers, RightIncludesPass) {
  EXPECT_EQ(include_fault("examples/x/tracer.cpp", "search.h", true), "");
  EXPECT_EQ(include_fault("renderer/math/rotation.cpp", "mpfr.h", false), "");
  EXPECT_EQ(include_fault("bench/peers/embree.cpp", "embree3/rtcore.h", false), "");
  EXPECT_EQ(include_fault("renderer/scene.cpp", "renderer/image/image.h", true), "");
  EXPECT_EQ(include_fault("renderer/image/image.cpp", "renderer/math/vec3.h", true), "");
  EXPECT_EQ(include_fault("tools/plumb/main.cpp", "conformance/judge/grade.h", true), "");
  EXPECT_EQ(include_fault("tools/plumb/main.cpp", "vector", false), "");
}

TEST(Layers, ASourceIncludesItsOwnHeaderFirst) {
  EXPECT_NE(first_include_fault("renderer/scene.cpp", "algorithm"), "");
  EXPECT_NE(first_include_fault("renderer/scene.cpp", "renderer/kinds.h"), "");
  EXPECT_EQ(first_include_fault("renderer/scene.cpp", "renderer/scene.h"), "");
  EXPECT_EQ(first_include_fault("examples/x/search.cpp", "search.h"), "");
}

TEST(Layers, StrangersLongFilesAndVagueNamesAreCaught) {
  EXPECT_NE(top_level_fault("scratch"), "");
  EXPECT_EQ(top_level_fault("suites"), "");
  EXPECT_EQ(top_level_fault(".ci"), "");
  EXPECT_NE(file_fault("renderer/scene.cpp", 501), "");
  EXPECT_EQ(file_fault("renderer/scene.cpp", 500), "");
  EXPECT_NE(file_fault("renderer/math_utils.h", 10), "");
  EXPECT_NE(file_fault("renderer/common.h", 10), "");
}

}  // namespace
}  // namespace plumb

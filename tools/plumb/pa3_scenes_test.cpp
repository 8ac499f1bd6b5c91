// The grading scenes, drawn by `plumb` and by the examples in C++, which share no code with it.

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "renderer/image/read_picture.h"
#include "tools/plumb/program_for_tests.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using testing::IsEmpty;

class Pa3ScenesByOthers : public ProgramTest {
 protected:
  /// Renders all scenes by an example and by `plumb`; returns those in which a pixel is off by more than a level.
  std::set<std::string> different_scenes(const std::string& example) {
    EXPECT_EQ(shell("g++ -O2 -std=c++17 -pthread -o tracer '" PLUMB_SOURCE_DIR "/examples/" + example + "/tracer.cpp'"),
              0)
        << complained_;
    EXPECT_EQ(shell("cp '" PLUMB_SOURCE_DIR "'/scenes/pa3/* . && ./tracer *.xml"), 0) << complained_;
    EXPECT_EQ(plumb("render '" PLUMB_SOURCE_DIR "/scenes/pa3' -o ours"), 0) << complained_;
    std::set<std::string> different;
    for (const auto& entry : fs::directory_iterator(folder_ / "ours")) {
      const fs::path name = entry.path().filename();
      ++compared_;
      if (pixels_apart(read_picture(entry.path()), read_picture(folder_ / name)) > 0)
        different.insert(name.stem().stem().string());
    }
    return different;
  }

  static std::size_t pixels_apart(const Picture& a, const Picture& b) {
    if (a.width != b.width || a.height != b.height) return std::max(a.samples.size(), b.samples.size()) / 3;
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.samples.size(); i += 3)
      for (std::size_t channel = 0; channel < 3; ++channel)
        if (std::abs(a.samples[i + channel] - b.samples[i + channel]) > 1) {
          ++count;
          break;
        }
    return count;
  }

  int compared_ = 0;
};

// Both are in double precision, and no ray of these scenes is so close to an edge that their formulas part there.
TEST_F(Pa3ScenesByOthers, TheCorrectExampleDrawsTheSame) {
  EXPECT_THAT(different_scenes("cpp-correct"), IsEmpty());
  EXPECT_EQ(compared_, 34);
}

// It transforms normals by the matrix, and weights the reflection of the glaze by 1 - R.
TEST_F(Pa3ScenesByOthers, TheFaultyOneDiffersInTheScenesOfItsFaults) {
  EXPECT_THAT(different_scenes("cpp-faulty"),
              testing::UnorderedElementsAre("bounds-many", "glazed", "glazed-deep", "mesh-transformed",
                                            "normals-transformed", "shared-names"));
  EXPECT_EQ(compared_, 34);
}

}  // namespace
}  // namespace plumb

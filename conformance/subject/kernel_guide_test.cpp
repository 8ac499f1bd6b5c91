// docs/kernel-guide.md and the kernel in C that it shows.
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <random>
#include <sstream>

#include "conformance/subject/kernel_cost.h"
#include "conformance/subject/kernel_subject.h"
#include "conformance/subject/shipped_kernels.h"
#include "meshes/generators/icosphere.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

class KernelGuide : public testing::Test {
 protected:
  KernelGuide() {
    std::string name = (fs::temp_directory_path() / "plumb-kernel-guide-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder for the test");
    folder_ = name;
  }
  ~KernelGuide() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  const fs::path source_ = PLUMB_SOURCE_DIR;
  const std::string guide_ = content(source_ / "docs/kernel-guide.md");
  fs::path folder_;
};

TEST_F(KernelGuide, ShowsTheWholeExample) {
  const std::string example = content(source_ / "examples/kernel-c/kernel.c");
  EXPECT_FALSE(example.empty());
  EXPECT_NE(guide_.find("```c\n" + example + "```"), std::string::npos)
      << "copy examples/kernel-c/kernel.c to the guide";
}

TEST_F(KernelGuide, ItsCommandMakesAKernelThatAnswersRightly) {
  const std::string command =
      "cc -std=c11 -O2 -shared -fPIC -I conformance/kernel examples/kernel-c/kernel.c -o kernel.so -lm";
  ASSERT_NE(guide_.find("\n" + command + "\n"), std::string::npos) << "the guide has another command";
  const std::string to = (folder_ / "kernel.so").string();
  std::string here = command;
  here.replace(here.find("kernel.so"), 9, "'" + to + "'");
  ASSERT_EQ(std::system(("cd '" + source_.string() + "' && " + here).c_str()), 0);

  SubjectScene scene(1);
  scene[0].shape.kind = ShapeKind::mesh;
  scene[0].shape.mesh = std::make_shared<const TriangleMesh>(icosphere(2));
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> u(-1, 1);
  std::vector<Ray> rays;
  for (int i = 0; i < 1000; ++i) {
    const Point3 origin{3 * u(random), 3 * u(random), 3 * u(random)};
    rays.push_back({origin, Point3{u(random), u(random), u(random)} - origin});
  }
  KernelSubject example(to);
  EXPECT_EQ(example.name(), "kernel-c");
  LocalKernelSubject reference(shipped_kernel("cgal"));
  example.load(scene);
  reference.load(scene);
  const auto hits = example.closest(rays);
  const auto expected = reference.closest(rays);
  int found = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    ASSERT_EQ(hits[i].surface, expected[i].surface) << i;
    if (!hits[i].hit()) continue;
    ++found;
    EXPECT_EQ(hits[i].primitive, expected[i].primitive) << i;
    EXPECT_NEAR(hits[i].t, expected[i].t, 1e-13) << i;  // some hundred units of t, which is below 8
  }
  EXPECT_GT(found, 500);
}

TEST(KernelCost, IsThatOfAskingAlone) {
  KernelSubject empty(shipped_kernel("empty"));
  for (const std::size_t rays : {1, 64, 4096}) {
    const AskingCost cost = asking_cost(empty, rays, 51);
    EXPECT_GT(cost.cpu_nanoseconds_a_ray, 0);
    EXPECT_GT(cost.clock_nanoseconds_a_ray, cost.cpu_nanoseconds_a_ray);
    RecordProperty("cpu_ns_a_ray_of_" + std::to_string(rays), std::to_string(cost.cpu_nanoseconds_a_ray));
    std::printf("%zu rays a call: %.1f ns CPU and %.1f ns on the clock a ray\n", rays, cost.cpu_nanoseconds_a_ray,
                cost.clock_nanoseconds_a_ray);
  }
}

}  // namespace
}  // namespace plumb

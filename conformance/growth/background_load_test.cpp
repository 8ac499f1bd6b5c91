#include "conformance/growth/background_load.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace plumb {
namespace {

/// The living children of this process.
int children() {
  int count = 0;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::ifstream stream(task.path() / "children");
    for (std::string pid; stream >> pid;) ++count;
  }
  return count;
}

TEST(BackgroundLoad, IsThereWhileItLives) {
  const int before = children();
  {
    const BackgroundLoad load(2);
    EXPECT_EQ(children(), before + 2);
  }
  EXPECT_EQ(children(), before);
}

}  // namespace
}  // namespace plumb

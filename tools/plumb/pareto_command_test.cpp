// `plumb check --pareto`, run as a program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace plumb {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

std::string content(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class ParetoCommandTest : public testing::Test {
 protected:
  ParetoCommandTest() {
    std::string name = (fs::temp_directory_path() / "plumb-pareto-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder for the test");
    folder_ = fs::canonical(name);
  }
  ~ParetoCommandTest() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  int check(const std::string& arguments, const std::string& before = "") {
    const std::string command = "cd '" + folder_.string() + "' && " + before + " '" PLUMB_PROGRAM "' check " +
                                arguments + " >said.txt 2>complained.txt";
    const int status = std::system(command.c_str());
    said_ = content(folder_ / "said.txt");
    complained_ = content(folder_ / "complained.txt");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  fs::path folder_;
  std::string said_, complained_;
};

TEST_F(ParetoCommandTest, WritesTablesAndPlots) {
  ASSERT_EQ(check("--pareto --filter 'mt-float,sphere-precise-float' --intensity 0.001 --seed 3 --out \"it's here\""),
            0)
      << complained_;
  EXPECT_THAT(complained_, testing::IsEmpty()) << "progress is for terminals";
  EXPECT_THAT(said_, HasSubstr("seed 3, intensity 0.001"));
  EXPECT_THAT(said_, HasSubstr("mt-double")) << "stands in every table";
  EXPECT_THAT(said_, HasSubstr("at vertices"));
  const fs::path out = folder_ / "it's here";
  EXPECT_THAT(said_, HasSubstr(content(out / "tables.txt")));
  for (const char* name : {"run", "kernels", "class", "escapes", "closest", "pictures"})
    EXPECT_THAT(content(out / (std::string(name) + ".csv")), HasSubstr("\n")) << name;
  for (const char* name : {"class", "escapes", "closest", "spheres", "pictures"}) {
    EXPECT_THAT(content(out / (std::string(name) + ".svg")), StartsWith("<?xml")) << name;
    EXPECT_THAT(content(out / (std::string(name) + ".svg")), HasSubstr("</svg>")) << name;
    EXPECT_FALSE(fs::exists(out / (std::string(name) + ".svg.partial")));
  }
}

TEST_F(ParetoCommandTest, SaysFirstThatGnuplotIsMissing) {
  EXPECT_EQ(check("--pareto", "PATH=/nonexistent"), 2);
  EXPECT_THAT(complained_, HasSubstr("gnuplot-nox"));
  EXPECT_FALSE(fs::exists(folder_ / "plumb-results"));
}

TEST_F(ParetoCommandTest, RefusesWhatItDoesNotTake) {
  EXPECT_EQ(check("embree --pareto"), 2);
  EXPECT_THAT(complained_, HasSubstr("no SUBJECT"));
  EXPECT_EQ(check("--pareto --json"), 2);
  EXPECT_EQ(check("--pareto --filter embre"), 2);
  EXPECT_THAT(complained_, HasSubstr("did you mean"));
}

}  // namespace
}  // namespace plumb

// The example submissions, graded by the program as `./dev demo` does it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using testing::UnorderedElementsAre;

std::string content(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class ExamplesTest : public testing::Test {
 protected:
  ExamplesTest() {
    std::string name = (fs::temp_directory_path() / "plumb-examples-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder for the test");
    folder_ = fs::canonical(name);
  }
  ~ExamplesTest() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  /// Runs a line of shell in which `plumb` is the program under test; returns its exit status, and keeps what it says.
  int run(const std::string& line) {
    const std::string path = fs::path(PLUMB_PROGRAM).parent_path().string();
    const std::string command =
        "cd '" + folder_.string() + "' && PATH='" + path + "':\"$PATH\" && { " + line + "; } >said.txt 2>&1";
    const int status = std::system(command.c_str());
    said_ = content(folder_ / "said.txt");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  /// A suite of the repository with references that `plumb render` makes now.
  fs::path own_suite(const std::string& name) {
    const std::string scenes = std::string(PLUMB_SOURCE_DIR) + "/scenes";
    EXPECT_EQ(run("plumb render '" + scenes + "/library' -o references"), 0) << said_;
    std::string text = content(fs::path(PLUMB_SOURCE_DIR) / "suites" / name);
    EXPECT_GT(replace_all(text, "../build/demo/references", folder_.string() + "/references"), 0);
    EXPECT_GT(replace_all(text, "../scenes", scenes), 0);
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }

  /// Grades an example and returns the cases that are not right; every case must have been judged.
  std::vector<std::string> wrong_cases(const std::string& example, const fs::path& suite, int expected_status,
                                       std::size_t expected_cases) {
    EXPECT_EQ(
        run("plumb grade '" PLUMB_SOURCE_DIR "/examples/" + example + "' --suite '" + suite.string() + "' --out out"),
        expected_status)
        << said_;
    results_ = nlohmann::json::parse(content(folder_ / "out/results.json"));
    EXPECT_THAT(results_["cases"], SizeIs(expected_cases));
    std::vector<std::string> wrong;
    for (const nlohmann::json& c : results_["cases"]) {
      if (c["verdict"] == "pass") continue;
      EXPECT_EQ(c["verdict"], "fail") << c;
      EXPECT_EQ(c["cause"], "different") << c;
      wrong.push_back(c["id"]);
    }
    return wrong;
  }

  void expect_equal_to_the_last_pixel() const {
    for (const nlohmann::json& c : results_["cases"]) {
      const nlohmann::json json =
          nlohmann::json::parse(content(folder_ / "out/cases" / c["id"].get<std::string>() / "case.json"));
      EXPECT_EQ(json["evidence"]["max_difference"], 0) << c["id"];
    }
  }

  static int replace_all(std::string& text, const std::string& what, const std::string& by) {
    int count = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()), ++count)
      text.replace(at, what.size(), by);
    return count;
  }

  fs::path folder_;
  std::string said_;
  nlohmann::json results_;
};

constexpr std::size_t kDemoCases = 12;

TEST_F(ExamplesTest, TheCorrectOneInCppPasses) {
  EXPECT_THAT(wrong_cases("cpp-correct", own_suite("demo.toml"), 0, kDemoCases), IsEmpty());
  EXPECT_EQ(results_["totals"]["points"], 100);
}

TEST_F(ExamplesTest, TheFaultyOneInCppFailsExactlyItsFaultyCases) {
  EXPECT_THAT(wrong_cases("cpp-faulty", own_suite("demo.toml"), 1, kDemoCases),
              UnorderedElementsAre("groups", "glazed"));
  EXPECT_EQ(results_["totals"]["points"], 78);
  for (const char* id : {"groups", "glazed"})
    EXPECT_TRUE(fs::exists(folder_ / "out/cases" / id / "difference.png")) << id;
}

TEST_F(ExamplesTest, TheOneInJavaFailsExactlyItsFaultyCase) {
  EXPECT_THAT(wrong_cases("java-course", own_suite("demo.toml"), 1, kDemoCases), ElementsAre("rotations"));
  EXPECT_EQ(results_["totals"]["points"], 92);
}

TEST_F(ExamplesTest, TheCompleteOneInJavaEqualsOurOwnPictures) {
  EXPECT_THAT(wrong_cases("java-complete", own_suite("demo.toml"), 0, kDemoCases), IsEmpty());
  EXPECT_EQ(results_["totals"]["points"], 100);
  expect_equal_to_the_last_pixel();
}

TEST_F(ExamplesTest, OurOwnTracerPassesThroughTheSameDoor) {
  EXPECT_THAT(wrong_cases("plumb", own_suite("demo.toml"), 0, kDemoCases), IsEmpty());
  expect_equal_to_the_last_pixel();
}

TEST_F(ExamplesTest, AnotherSceneFormatPasses) {
  EXPECT_THAT(wrong_cases("text-spheres", own_suite("text-spheres.toml"), 0, 1), IsEmpty());
}

#ifdef PLUMB_COURSE_SUITE
constexpr std::size_t kCourseScenes = 10;

TEST_F(ExamplesTest, OurOwnTracerEqualsTheCoursesPictures) {
  EXPECT_THAT(wrong_cases("plumb", PLUMB_COURSE_SUITE, 0, kCourseScenes), IsEmpty());
  EXPECT_EQ(results_["totals"]["points"], 100);
  expect_equal_to_the_last_pixel();
}

TEST_F(ExamplesTest, TheCorrectOneInCppEqualsTheCoursesPictures) {
  EXPECT_THAT(wrong_cases("cpp-correct", PLUMB_COURSE_SUITE, 0, kCourseScenes), IsEmpty());
  EXPECT_EQ(results_["totals"]["points"], 100);
  expect_equal_to_the_last_pixel();
}

TEST_F(ExamplesTest, TheOneInJavaFailsTheCoursesTurnedScenes) {
  EXPECT_THAT(wrong_cases("java-course", PLUMB_COURSE_SUITE, 1, kCourseScenes),
              UnorderedElementsAre("sphereSquished", "sphereMeshSquished"));
  EXPECT_EQ(results_["totals"]["points"], 80);
}

TEST_F(ExamplesTest, TheCompleteOneInJavaEqualsTheCoursesPictures) {
  EXPECT_THAT(wrong_cases("java-complete", PLUMB_COURSE_SUITE, 0, kCourseScenes), IsEmpty());
  EXPECT_EQ(results_["totals"]["points"], 100);
  expect_equal_to_the_last_pixel();
}

TEST_F(ExamplesTest, TheFaultyOneInCppFailsTheCoursesScenesOfItsFaults) {
  EXPECT_THAT(wrong_cases("cpp-faulty", PLUMB_COURSE_SUITE, 1, kCourseScenes),
              UnorderedElementsAre("sphereSquished", "sphereMeshSquished", "glazed-ball", "Test4-glazed"));
}
#endif

}  // namespace

#include "conformance/judge/commands.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

TEST(GlobMatches, FollowsTheTable) {
  const struct {
    const char* glob;
    const char* path;
    bool matches;
  } table[] = {
      {"*.java", "A.java", true},
      {"*.java", "ray/A.java", false},
      {"*.java", "A.javac", false},
      {"*.java", "A.JAVA", false},
      {"**/*.java", "A.java", true},
      {"**/*.java", "ray/A.java", true},
      {"**/*.java", "a/b/c/A.java", true},
      {"ray/**/*.java", "ray/A.java", true},
      {"ray/**/*.java", "ray/x/y/A.java", true},
      {"ray/**/*.java", "A.java", false},
      {"ray/**/*.java", "x/ray/A.java", false},
      {"**", "a/b/c", true},
      {"**/ray/*", "a/b/ray/c", true},
      {"**/ray/*", "a/b/ray/c/d", false},
      {"?.c", "a.c", true},
      {"?.c", "ab.c", false},
      {"?.c", "/.c", false},
      {"a*b", "a/b", false},
      {"a**b", "axxb", true},
      {"a**b", "a/b", false},
      {"[ab].c", "a.c", true},
      {"[ab].c", "c.c", false},
      {"main.c", "main.c", true},
      {"main.c", "x/main.c", false},
      {"**/**/*.c", "a.c", true},
      {"*/*/*.c", "a/b/c.c", true},
      {"*/*/*.c", "a/c.c", false},
      {"*", ".hidden", true},
  };
  for (const auto& row : table)
    EXPECT_EQ(glob_matches(row.glob, row.path), row.matches) << row.glob << " and " << row.path;
}

class BuildCommandTest : public testing::Test {
 protected:
  BuildCommandTest() {
    std::string name = (fs::temp_directory_path() / "plumb-commands-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder for the test");
    folder_ = fs::canonical(name);
  }
  ~BuildCommandTest() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  void make(const std::string& name) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << "";
  }
  fs::path folder_;
};

TEST_F(BuildCommandTest, NamesTheSourcesInOrder) {
  for (const char* name : {"ray/b.java", "ray/a.java", "Z.java", "ray/a.class", "ray/deep/er/c.java"}) make(name);
  EXPECT_THAT(build_command({"javac", "-d", "out", "{sources:**/*.java}", "-g"}, folder_),
              ElementsAre("javac", "-d", "out", "Z.java", "ray/a.java", "ray/b.java", "ray/deep/er/c.java", "-g"));
}

TEST_F(BuildCommandTest, ANameThatLooksLikeAnOptionIsNone) {
  make("-rf.java");
  make("a.java");
  EXPECT_THAT(build_command({"javac", "{sources:*.java}"}, folder_), ElementsAre("javac", "./-rf.java", "a.java"));
}

TEST_F(BuildCommandTest, StrangeNamesStayOneArgument) {
  for (const char* name : {"a b.c", "a\nb.c", "it's.c", "$(x).c", "{scene}.c"}) make(name);
  EXPECT_THAT(build_command({"{sources:*.c}"}, folder_),
              ElementsAre("$(x).c", "a\nb.c", "a b.c", "it's.c", "{scene}.c"));
}

TEST_F(BuildCommandTest, AFolderIsNoSource) {
  fs::create_directory(folder_ / "x.c");
  EXPECT_THROW(build_command({"{sources:*.c}"}, folder_), InputError);
  make("x.c/y.c");
  EXPECT_THAT(build_command({"{sources:**/*.c}"}, folder_), ElementsAre("x.c/y.c"));
}

TEST_F(BuildCommandTest, NoSourceIsAnError) {
  make("a.cpp");
  try {
    build_command({"cc", "{sources:src/*.c}"}, folder_);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "no file of the submission matches 'src/*.c'");
  }
}

CasePaths paths_with(const std::string& scene_at, const std::string& output) {
  Runner runner;
  runner.scene_at = scene_at;
  runner.output = output;
  SuiteCase suite_case;
  suite_case.scene = "/somewhere/else/ball.xml";
  return case_paths(runner, suite_case);
}

TEST(CasePaths, FollowTheRunner) {
  const struct {
    const char* scene_at;
    const char* output;
    const char* scene;
    const char* folder;
    const char* picture;
  } table[] = {
      {"", "{scene}.png", "ball.xml", ".", "ball.xml.png"},
      {"data/scenes/", "{scene}.png", "data/scenes/ball.xml", "data/scenes", "data/scenes/ball.xml.png"},
      {"data/scenes", "{scene}.png", "data/scenes/ball.xml", "data/scenes", "data/scenes/ball.xml.png"},
      {"./data//scenes/.", "{scene}.png", "data/scenes/ball.xml", "data/scenes", "data/scenes/ball.xml.png"},
      {".", "{folder}/{scene_name}.ppm", "ball.xml", ".", "ball.xml.ppm"},
      {"data/", "out/{scene_name}.png", "data/ball.xml", "data", "out/ball.xml.png"},
      {"data/", "{folder}/picture.png", "data/ball.xml", "data", "data/picture.png"},
      {"data/", "picture.png", "data/ball.xml", "data", "picture.png"},
  };
  for (const auto& row : table) {
    const CasePaths paths = paths_with(row.scene_at, row.output);
    EXPECT_EQ(paths.scene, row.scene) << row.scene_at;
    EXPECT_EQ(paths.scene_name, "ball.xml");
    EXPECT_EQ(paths.folder, row.folder) << row.scene_at;
    EXPECT_EQ(paths.output, row.picture) << row.scene_at << " " << row.output;
  }
}

TEST(RenderCommand, FillsInEveryPlaceholder) {
  Runner runner;
  runner.render = {"./t", "{scene}", "-o{output}", "{folder}:{scene_name}", "{scene}{scene}", "{ }", "{"};
  const CasePaths paths = paths_with("data/", "{scene}.png");
  EXPECT_THAT(render_command(runner, paths), ElementsAre("./t", "data/ball.xml", "-odata/ball.xml.png", "data:ball.xml",
                                                         "data/ball.xmldata/ball.xml", "{ }", "{"));
}

TEST(GlobMatches, ManyDoubleStarsAreNotExponential) {
  std::string glob, path;
  for (int i = 0; i < 20; ++i) glob += "**/";
  for (int i = 0; i < 60; ++i) path += "d/";
  EXPECT_FALSE(glob_matches(glob + "x.c", path + "y.c"));
  EXPECT_TRUE(glob_matches(glob + "y.c", path + "y.c"));
}

TEST_F(BuildCommandTest, ANameThatLooksLikeAnArgumentFileIsNone) {
  make("@x.java");
  EXPECT_THAT(build_command({"{sources:*.java}"}, folder_), ElementsAre("./@x.java"));
}

TEST_F(BuildCommandTest, HiddenFilesNeverMatch) {
  make("x.java");
  make("._x.java");
  make(".svn/text-base/x.java");
  EXPECT_THAT(build_command({"{sources:**/*.java}"}, folder_), ElementsAre("x.java"));
}

}  // namespace
}  // namespace plumb

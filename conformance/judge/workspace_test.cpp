#include "conformance/judge/workspace.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

class WorkspaceTest : public testing::Test {
 protected:
  WorkspaceTest() {
    std::string name = (fs::temp_directory_path() / "plumb-workspace-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder for the test");
    folder_ = fs::canonical(name);
    fs::create_directory(sub());
    write("inputs/scene.xml", "the scene");
    write("inputs/mesh.msh", "the mesh");
    case_.id = "a";
    case_.scene = folder_ / "inputs/scene.xml";
    case_.inputs = {folder_ / "inputs/mesh.msh", case_.scene};
  }
  ~WorkspaceTest() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  fs::path sub() const { return folder_ / "sub"; }
  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  /// A workspace with the sealed submission.
  void seal(Workspace& workspace) const {
    workspace.copy_submission(sub(), suite_);
    workspace.seal_build();
  }

  fs::path folder_;
  Suite suite_;
  SuiteCase case_;
  Runner runner_;
};

std::string content(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  return names;
}

TEST_F(WorkspaceTest, TheRootIsTheNearestFolderWithTheMarker) {
  write("sub/ray/Main.java", "top");
  write("sub/old/ray/Main.java", "older");
  EXPECT_EQ(find_roots(sub(), "ray/Main.java").front(), sub());
  fs::remove(sub() / "ray/Main.java");
  EXPECT_EQ(find_roots(sub(), "ray/Main.java").front(), sub() / "old");
  fs::rename(sub() / "old", sub() / "unpacked");
  fs::create_directory(sub() / "twice");
  fs::rename(sub() / "unpacked", sub() / "twice/unpacked");
  EXPECT_EQ(find_roots(sub(), "ray/Main.java").front(), sub() / "twice/unpacked");
  write("sub/b/ray/Main.java", "");
  write("sub/a/ray/Main.java", "");
  EXPECT_EQ(find_roots(sub(), "ray/Main.java").front(), sub() / "a") << "of two equally near the first by name";
  EXPECT_THROW(find_roots(sub(), "none"), InputError);
}

TEST_F(WorkspaceTest, ACopyStartsFromTheRoot) {
  write("sub/handed in/project/ray/Main.java", "x");
  write("sub/readme", "");
  suite_.root_marker = "ray/Main.java";
  Workspace workspace;
  workspace.copy_submission(sub(), suite_);
  EXPECT_THAT(names_in(workspace.build()), ElementsAre("ray"));
}

TEST_F(WorkspaceTest, StaffFilesStandBeforeThoseOfTheSubmission) {
  write("sub/ray/Main.java", "theirs");
  write("sub/ray/Own.java", "own");
  write("staff/ray/Main.java", "ours");
  write("staff/ray/Test.java", "test");
  suite_.overlay = folder_ / "staff";
  Workspace workspace;
  workspace.copy_submission(sub(), suite_);
  EXPECT_EQ(content(workspace.build() / "ray/Main.java"), "ours");
  EXPECT_EQ(content(workspace.build() / "ray/Own.java"), "own");
  EXPECT_EQ(content(workspace.build() / "ray/Test.java"), "test");
}

TEST_F(WorkspaceTest, LinksAndPipesAreLeftOutAndNamed) {
  write("sub/a.c", "a");
  write("sub/deep/b.c", "b");
  fs::create_symlink("/etc/passwd", sub() / "secret.h");
  fs::create_directory_symlink("/etc", sub() / "deep/etc");
  ASSERT_EQ(::mkfifo((sub() / "deep/pipe").c_str(), 0600), 0);
  Workspace workspace;
  workspace.copy_submission(sub(), suite_);
  EXPECT_THAT(workspace.left_out().not_ordinary, UnorderedElementsAre("secret.h", "deep/etc", "deep/pipe"));
  EXPECT_THAT(names_in(workspace.build()), UnorderedElementsAre("a.c", "deep"));
  EXPECT_THAT(names_in(workspace.build() / "deep"), ElementsAre("b.c"));
}

TEST_F(WorkspaceTest, PicturesAreStaleAndLeftOut) {
  for (const char* name : {"sub/a.png", "sub/deep/b.PPM", "sub/deep/c.exr", "sub/png", "sub/d.png.txt"})
    write(name, "x");
  Workspace workspace;
  workspace.copy_submission(sub(), suite_);
  EXPECT_EQ(workspace.left_out().pictures, 3);
  EXPECT_THAT(workspace.left_out().not_ordinary, IsEmpty());
  EXPECT_THAT(names_in(workspace.build()), UnorderedElementsAre("deep", "png", "d.png.txt"));
  EXPECT_THAT(names_in(workspace.build() / "deep"), IsEmpty());
}

TEST_F(WorkspaceTest, StrangeNamesAreCopied) {
  const std::vector<std::string> names{"a b", "a\nb", "it's", "\"", "-rf", "\xff\xfe", "$(x)", "*"};
  for (const std::string& name : names) write("sub/" + name, name);
  Workspace workspace;
  seal(workspace);
  const Workspace::CaseFolder folder = workspace.make_case_folder(case_, runner_);
  for (const std::string& name : names) EXPECT_EQ(content(folder.run / name), name);
}

TEST_F(WorkspaceTest, ACaseSeesTheBuildThroughLinksAndTheInputsAsCopies) {
  write("sub/tracer", "program");
  write("sub/lib/part", "part");
  Workspace workspace;
  seal(workspace);
  const Workspace::CaseFolder folder = workspace.make_case_folder(case_, runner_);
  EXPECT_THAT(names_in(folder.run), UnorderedElementsAre("tracer", "lib", "scene.xml", "mesh.msh"));
  EXPECT_TRUE(fs::is_symlink(folder.run / "tracer"));
  EXPECT_EQ(content(folder.run / "lib/part"), "part");
  EXPECT_FALSE(fs::is_symlink(folder.run / "scene.xml"));
  EXPECT_EQ(fs::hard_link_count(folder.run / "scene.xml"), 1U);
  std::ofstream(folder.run / "scene.xml") << "changed";
  EXPECT_EQ(content(folder_ / "inputs/scene.xml"), "the scene");
  EXPECT_TRUE(fs::is_directory(folder.home));
  EXPECT_THAT(names_in(folder.home), IsEmpty());
}

TEST_F(WorkspaceTest, AFolderOfScenesHoldsTheInputsAlone) {
  for (const char* name : {"sub/data/scenes/old.xml", "sub/data/scenes/scene.xml", "sub/data/scenes/scene.xml.png",
                           "sub/data/other/texture.txt", "sub/tracer", "sub/data/stale.PNG"})
    write(name, "theirs");
  runner_.scene_at = "data/scenes/";
  Workspace workspace;
  seal(workspace);
  const Workspace::CaseFolder folder = workspace.make_case_folder(case_, runner_);
  EXPECT_THAT(names_in(folder.run / "data/scenes"), UnorderedElementsAre("scene.xml", "mesh.msh"));
  EXPECT_EQ(content(folder.run / "data/scenes/scene.xml"), "the scene");
  EXPECT_EQ(content(folder.run / "data/other/texture.txt"), "theirs");
  EXPECT_THAT(names_in(folder.run / "data"), UnorderedElementsAre("scenes", "other"));
  EXPECT_TRUE(workspace.check_build()) << "the build itself is untouched";
}

TEST_F(WorkspaceTest, AnInputStandsBeforeAFileOfTheSubmission) {
  write("sub/scene.xml", "theirs");
  write("sub/mesh.msh/is/a/folder", "theirs");
  Workspace workspace;
  seal(workspace);
  const Workspace::CaseFolder folder = workspace.make_case_folder(case_, runner_);
  EXPECT_EQ(content(folder.run / "scene.xml"), "the scene");
  EXPECT_EQ(content(folder.run / "mesh.msh"), "the mesh");
}

TEST_F(WorkspaceTest, AFolderForThePictureIsRealAndHoldsNoStaleOne) {
  write("sub/out/notes.txt", "notes");
  write("sub/out/picture.png", "stale");
  runner_.output = "out/picture.png";
  Workspace workspace;
  seal(workspace);
  const Workspace::CaseFolder folder = workspace.make_case_folder(case_, runner_);
  EXPECT_FALSE(fs::is_symlink(folder.run / "out"));
  EXPECT_THAT(names_in(folder.run / "out"), ElementsAre("notes.txt"));
  runner_.output = "new/deep/picture.png";
  EXPECT_TRUE(fs::is_directory(workspace.make_case_folder(case_, runner_).run / "new/deep"));
}

TEST_F(WorkspaceTest, EveryFolderOfACaseIsFresh) {
  write("sub/tracer", "program");
  Workspace workspace;
  seal(workspace);
  const Workspace::CaseFolder first = workspace.make_case_folder(case_, runner_);
  std::ofstream(first.run / "cache") << "state";
  fs::remove(first.run / "tracer");
  const Workspace::CaseFolder again = workspace.make_case_folder(case_, runner_);
  EXPECT_THAT(names_in(again.run), UnorderedElementsAre("tracer", "scene.xml", "mesh.msh"));
}

TEST_F(WorkspaceTest, AChangedBuildIsPutBack) {
  write("sub/tracer", "program");
  write("sub/lib/part", "part");
  Workspace workspace;
  seal(workspace);
  const fs::path build = workspace.build();
  EXPECT_TRUE(workspace.check_build());
  EXPECT_EQ(fs::status(build / "tracer").permissions() & fs::perms::owner_write, fs::perms::none);
  const auto writable = [&] {
    fs::permissions(build, fs::perms::owner_all, fs::perm_options::add);
    fs::permissions(build / "lib", fs::perms::owner_all, fs::perm_options::add);
  };
  const std::vector<std::pair<const char*, std::function<void()>>> changes{
      {"grown",
       [&] {
         fs::permissions(build / "tracer", fs::perms::owner_write, fs::perm_options::add);
         std::ofstream(build / "tracer", std::ios::app) << "x";
       }},
      {"same size",
       [&] {
         fs::permissions(build / "tracer", fs::perms::owner_write, fs::perm_options::add);
         std::ofstream(build / "tracer") << "PROGRAM";
       }},
      {"same size, and the time put back",
       [&] {
         const fs::file_time_type time = fs::last_write_time(build / "tracer");
         fs::permissions(build / "tracer", fs::perms::owner_write, fs::perm_options::add);
         std::ofstream(build / "tracer") << "PROGRAM";
         fs::last_write_time(build / "tracer", time);
         fs::permissions(build / "tracer", fs::perms::owner_write, fs::perm_options::remove);
       }},
      {"permissions", [&] { fs::permissions(build / "lib/part", fs::perms::owner_exec, fs::perm_options::add); }},
      {"removed",
       [&] {
         writable();
         fs::remove(build / "lib/part");
       }},
      {"added",
       [&] {
         writable();
         std::ofstream(build / "lib/more") << "x";
       }},
      {"linked",
       [&] {
         writable();
         fs::remove(build / "lib/part");
         fs::create_symlink("/etc/passwd", build / "lib/part");
       }},
      {"all gone",
       [&] {
         writable();
         fs::remove_all(build);
       }},
      {"a link instead",
       [&] {
         writable();
         fs::remove_all(build);
         fs::create_directory_symlink("/etc", build);
       }},
      {"a file instead",
       [&] {
         writable();
         fs::remove_all(build);
         std::ofstream(build.string()) << "x";
       }},
  };
  for (const auto& [name, change] : changes) {
    change();
    EXPECT_FALSE(workspace.check_build()) << name;
    EXPECT_TRUE(workspace.check_build()) << name << ": put back";
    EXPECT_EQ(content(build / "tracer"), "program") << name;
    EXPECT_EQ(content(build / "lib/part"), "part") << name;
    EXPECT_THAT(names_in(build / "lib"), ElementsAre("part")) << name;
    EXPECT_FALSE(fs::is_symlink(build)) << name;
  }
  EXPECT_TRUE(fs::exists("/etc/passwd"));
}

TEST_F(WorkspaceTest, NothingIsLeftBehindWhateverTheSubmissionDid) {
  write("sub/tracer", "program");
  fs::path root;
  {
    Workspace workspace;
    seal(workspace);
    root = workspace.build().parent_path();
    const Workspace::CaseFolder folder = workspace.make_case_folder(case_, runner_);
    fs::create_directories(folder.run / "closed/inner");
    std::ofstream(folder.run / "closed/inner/file") << "x";
    ASSERT_EQ(::chmod((folder.run / "closed/inner").c_str(), 0), 0);
    ASSERT_EQ(::chmod((folder.run / "closed").c_str(), 0), 0);
    fs::create_directory_symlink(folder_, folder.run / "link");
    EXPECT_TRUE(fs::exists(root));
  }
  EXPECT_FALSE(fs::exists(root));
  EXPECT_TRUE(fs::exists(folder_ / "inputs/scene.xml")) << "links are not followed";
}

TEST_F(WorkspaceTest, ReadOnlyFilesAreCopiedSoThatABuildCanWrite) {
  write("sub/a.c", "a");
  fs::permissions(sub() / "a.c", fs::perms::owner_read);
  fs::permissions(case_.scene, fs::perms::owner_read);
  Workspace workspace;
  workspace.copy_submission(sub(), suite_);
  EXPECT_NE(fs::status(workspace.build() / "a.c").permissions() & fs::perms::owner_write, fs::perms::none);
  workspace.seal_build();
  const Workspace::CaseFolder folder = workspace.make_case_folder(case_, runner_);
  EXPECT_NE(fs::status(folder.run / "scene.xml").permissions() & fs::perms::owner_write, fs::perms::none);
}

TEST_F(WorkspaceTest, HiddenFoldersAreNoRootsAndOthersAreListed) {
  write("sub/.svn/ray/Main.java", "stale");
  write("sub/smith/ray/Main.java", "");
  EXPECT_EQ(find_roots(sub(), "ray/Main.java"), std::vector<fs::path>{sub() / "smith"});
  write("sub/jones/ray/Main.java", "");
  EXPECT_EQ(find_roots(sub(), "ray/Main.java"), (std::vector<fs::path>{sub() / "jones", sub() / "smith"}));
}

}  // namespace
}  // namespace plumb

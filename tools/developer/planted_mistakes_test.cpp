#include "tools/developer/planted_mistakes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::SizeIs;

const fs::path kRoot = PLUMB_SOURCE_DIR;
const fs::path kMutants = kRoot / "conformance" / "mutants";

PlantedMistake mistake(const std::string& id, const std::string& find, const std::string& replace) {
  return {id, id, {id}, {{"examples/x/a.cpp", find, replace}}};
}

TEST(Plant, ChangesTheFileThatTheEditNames) {
  const SourceTree sources{{"examples/x/a.cpp", "one two"}, {"examples/x/b.cpp", "one two"}};
  const SourceTree changed = plant(mistake("m", "two", "three"), sources);
  EXPECT_EQ(changed.at("examples/x/a.cpp"), "one three");
  EXPECT_EQ(changed.at("examples/x/b.cpp"), "one two");
}

TEST(Plant, RefusesATextThatIsNotThereOnce) {
  const SourceTree sources{{"examples/x/a.cpp", "one two two"}};
  EXPECT_THROW(plant(mistake("m", "two", "three"), sources), InputError);
  EXPECT_THROW(plant(mistake("m", "four", "three"), sources), InputError);
  EXPECT_THROW(plant(mistake("m", "one", "three"), {{"examples/x/b.cpp", "one"}}), InputError);
}

TEST(PairPrograms, HoldBothMistakesAndNoneOfAName) {
  const SourceTree sources{{"examples/x/a.cpp", "a b c"}};
  PlantedMistake unnamed = mistake("u", "c", "z");
  unnamed.same_as.clear();
  const std::vector<PlantedProgram> pairs =
      pair_programs({mistake("m", "a", "x"), mistake("n", "b", "y"), unnamed}, sources, 10, 1);
  ASSERT_THAT(pairs, SizeIs(1));
  EXPECT_EQ(pairs[0].label, "m+n");
  EXPECT_EQ(pairs[0].sources.at("examples/x/a.cpp"), "x y c");
}

TEST(ReadPlantedMistakes, RefusesTwoPrograms) {
  const fs::path folder = fs::path(::testing::TempDir()) / "two-programs";
  fs::create_directories(folder);
  for (const std::string name : {"a", "b"})
    std::ofstream(folder / (name + ".toml"))
        << "name = 'x'\nsame_as = []\n[[edit]]\nfile = 'examples/" << name << "/m.cpp'\nfind = 'x'\nreplace = 'y'\n";
  EXPECT_THROW(read_planted_mistakes(folder), InputError);
}

/// A folder of planted changes, and how many it has at least.
struct Folder {
  const char* path;
  std::size_t least;
};

/// What is written down can be planted in the program as it is, and is named as the known bugs are.
TEST(PlantedMistakes, FitTheExamples) {
  for (const Folder& folder :
       {Folder{"planted/cpp", 50}, Folder{"planted/java", 40}, Folder{"correct/cpp", 20}, Folder{"correct/java", 15}}) {
    const std::vector<PlantedMistake> mistakes = read_planted_mistakes(kMutants / folder.path);
    const SourceTree sources = read_sources(kRoot, program_of(mistakes));
    EXPECT_GE(mistakes.size(), folder.least) << folder.path;
    for (const PlantedMistake& m : mistakes) {
      EXPECT_NE(plant(m, sources), sources) << m.id;
      for (const std::string& id : m.same_as)
        EXPECT_TRUE(fs::exists(kMutants / "known" / (id + ".toml"))) << folder.path << "/" << m.id << ": " << id;
      if (std::string(folder.path).starts_with("correct")) {
        EXPECT_THAT(m.same_as, SizeIs(0)) << m.id;
      }
    }
  }
}

TEST(PlantedMistakes, BecomeFloatPrograms) {
  const std::string text = in_single_precision("const double kEpsilon = 1e-6; double_it(std::max(0.0, x));");
  EXPECT_EQ(text, "const float kEpsilon = 1e-4; double_it(std::max<float>(0, x));");
}

TEST(PlantedMistakes, FilesAreReadStrictly) {
  const fs::path folder = fs::temp_directory_path() / ("plumb-planted-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const auto message = [&](const std::string& text) -> std::string {
    std::ofstream(folder / "one.toml") << text;
    try {
      read_planted_mistakes(folder);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const std::string edit = "[[edit]]\nfile = 'examples/a/a.cpp'\nfind = 'x'\nreplace = 'y'\n";
  EXPECT_EQ(message("name = 'One'\nsame_as = []\n" + edit), "");
  EXPECT_THAT(message("name = 'One'\nsame_as = []\n"), HasSubstr("changes nothing"));
  EXPECT_THAT(message("nam = 'One'\n" + edit), HasSubstr("'name'"));
  EXPECT_THAT(message("name = 'One'\nsane_as = []\n" + edit), HasSubstr("sane_as"));
  fs::remove(folder / "one.toml");
  EXPECT_THROW(read_planted_mistakes(folder), InputError);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace plumb

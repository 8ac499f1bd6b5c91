#include "tools/developer/planted_mistakes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
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
      if (std::string(folder.path).starts_with("correct")) EXPECT_THAT(m.same_as, SizeIs(0)) << m.id;
    }
  }
}

}  // namespace
}  // namespace plumb

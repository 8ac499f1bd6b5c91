#include "tools/developer/planted_mistakes.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::string content(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string cpp_example() { return content(fs::path(PLUMB_SOURCE_DIR) / "examples/cpp-correct/tracer.cpp"); }

std::vector<PlantedMistake> cpp_mistakes() {
  return read_planted_mistakes(fs::path(PLUMB_SOURCE_DIR) / "conformance/mutants/planted/cpp");
}

PlantedMistake mistake(std::string id, std::string find, std::string replace) {
  return {std::move(id), "A mistake", {id}, {{"a.cpp", std::move(find), std::move(replace)}}};
}

TEST(PlantedMistakes, FitTheExampleTheyChange) {
  const std::string source = cpp_example();
  int planted = 0, known = 0;
  for (const PlantedMistake& one : cpp_mistakes()) {
    EXPECT_NE(plant(one, source), source) << one.id;
    ++planted, known += one.same_as.empty() ? 0 : 1;
  }
  EXPECT_GE(planted, 24);
  EXPECT_GE(known, 24);
}

TEST(PlantedMistakes, PairsAreDrawnWithoutRepeats) {
  const auto mistakes = cpp_mistakes();
  const auto pairs = pair_programs(mistakes, cpp_example(), 30, 5);
  ASSERT_EQ(pairs.size(), 30u);
  std::vector<std::string> labels;
  for (const PlantedProgram& pair : pairs) {
    EXPECT_EQ(pair.mistakes.size(), 2u);
    EXPECT_FALSE(pair.mistakes[0].same_as.empty() || pair.mistakes[1].same_as.empty()) << pair.label;
    labels.push_back(pair.label);
  }
  std::ranges::sort(labels);
  EXPECT_EQ(std::ranges::adjacent_find(labels), labels.end());
  EXPECT_EQ(pair_programs(mistakes, cpp_example(), 30, 5)[7].label, pairs[7].label);
  EXPECT_EQ(single_programs(mistakes, cpp_example()).size(), mistakes.size());
}

TEST(PlantedMistakes, StaleOnesAreRefused) {
  for (const std::string text : {"int b;", "int a; int a;"}) try {
      plant(mistake("stale", "int a;", "int c;"), text);
      FAIL() << text;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("stale"));
      EXPECT_THAT(error.what(), HasSubstr("expected once"));
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
  const std::string edit = "[[edit]]\nfile = 'a.cpp'\nfind = 'x'\nreplace = 'y'\n";
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

// Writes the sources of programs with planted mistakes, each into a folder of its own with the names that are right for
// it; planted_pictures.sh builds and runs them.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "renderer/image/staged_file.h"
#include "renderer/math/input_error.h"
#include "tools/developer/planted_mistakes.h"

namespace fs = std::filesystem;

namespace {

std::string content(const fs::path& file) {
  std::ifstream stream(file);
  if (!stream) throw plumb::InputError({file.string()}, "cannot be opened, expected the source to plant mistakes in");
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// `expected` has a line for each planted mistake, with the ids of the known bugs that are the right name for it.
void write(const plumb::PlantedProgram& program, const fs::path& folder, const std::string& file_name) {
  fs::create_directories(folder);
  std::string expected;
  for (const plumb::PlantedMistake& mistake : program.mistakes) {
    for (const std::string& id : mistake.same_as) expected += id + " ";
    expected += "\n";
  }
  plumb::write_file_staged(folder / "expected", expected);
  plumb::write_file_staged(folder / file_name, program.source);
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app("Writes programs with planted mistakes: OUT/LABEL/SOURCE.cpp and OUT/LABEL/expected");
  fs::path planted, out, root = ".", source_file;
  std::size_t pairs = 0;
  std::uint64_t seed = 1;
  bool single = false;
  app.add_option("planted", planted, "Folder of planted mistakes (*.toml)")->required()->check(CLI::ExistingDirectory);
  app.add_option("out", out, "Folder for the programs")->required();
  app.add_option("--root", root, "Of the project, which the edits' files are relative to")->capture_default_str();
  app.add_option("--source", source_file, "In place of the file that the edits name");
  app.add_option("--pairs", pairs, "So many pairs of mistakes, not single ones");
  app.add_option("--seed", seed, "For the choice of pairs")->capture_default_str();
  app.add_flag("--single-precision", single, "Programs that compute in floats");
  CLI11_PARSE(app, argc, argv);

  const std::vector<plumb::PlantedMistake> mistakes = plumb::read_planted_mistakes(planted);
  const fs::path file = source_file.empty() ? root / mistakes[0].edits[0].file : source_file;
  const std::string source = content(file);
  std::vector<plumb::PlantedProgram> programs =
      pairs > 0 ? plumb::pair_programs(mistakes, source, pairs, seed) : plumb::single_programs(mistakes, source);
  if (pairs == 0) programs.push_back({"right", source, {}});
  for (plumb::PlantedProgram& program : programs) {
    if (single) program.source = plumb::in_single_precision(program.source), program.label += "-float";
    write(program, out / program.label, file.filename().string());
  }
  fmt::print("{} programs\n", programs.size());
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 2;
}

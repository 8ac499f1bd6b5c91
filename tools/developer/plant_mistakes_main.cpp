// Writes programs with planted changes, each into a folder of its own with the names that are right for it;
// planted_pictures.sh builds and runs them.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "renderer/image/staged_file.h"
#include "tools/developer/planted_mistakes.h"

namespace fs = std::filesystem;

namespace {

/// The sources as they lie in the example, and the file `expected`, with a line for each planted mistake: the ids of
/// the known bugs that are the right name for it.
void write(const plumb::PlantedProgram& program, const std::string& example, const fs::path& folder) {
  std::string expected;
  for (const plumb::PlantedMistake& mistake : program.mistakes) {
    for (const std::string& id : mistake.same_as) expected += id + " ";
    expected += "\n";
  }
  for (const auto& [path, text] : program.sources) {
    const fs::path file = folder / fs::path(path).lexically_relative(example);
    fs::create_directories(file.parent_path());
    plumb::write_file_staged(file, text);
  }
  plumb::write_file_staged(folder / "expected", expected);
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app(
      "Writes programs with planted changes: OUT/LABEL/ with the sources of the example, and OUT/LABEL/expected");
  fs::path planted, out, root = ".", source_file;
  std::size_t pairs = 0;
  std::uint64_t seed = 1;
  bool single = false;
  app.add_option("planted", planted, "Folder of planted changes (*.toml)")->required()->check(CLI::ExistingDirectory);
  app.add_option("out", out, "Folder for the programs")->required();
  app.add_option("--root", root, "Of the project, which the edits' files are relative to")->capture_default_str();
  app.add_option("--source", source_file, "In place of the file that the edits name");
  app.add_option("--pairs", pairs, "So many pairs of mistakes, not single ones");
  app.add_option("--seed", seed, "For the choice of pairs")->capture_default_str();
  app.add_flag("--single-precision", single, "Programs that compute in floats; of C++ alone");
  CLI11_PARSE(app, argc, argv);

  const std::vector<plumb::PlantedMistake> mistakes = plumb::read_planted_mistakes(planted);
  const std::string example = plumb::program_of(mistakes);
  plumb::SourceTree sources = plumb::read_sources(root, example);
  if (!source_file.empty()) sources[mistakes[0].edits[0].file] = plumb::read_source(source_file);
  std::vector<plumb::PlantedProgram> programs =
      pairs > 0 ? plumb::pair_programs(mistakes, sources, pairs, seed) : plumb::single_programs(mistakes, sources);
  if (pairs == 0) programs.push_back({"right", sources, {}});
  for (plumb::PlantedProgram& program : programs) {
    if (single) {
      program.label += "-float";
      for (auto& [path, text] : program.sources)
        if (fs::path(path).extension() == ".cpp") text = plumb::in_single_precision(text);
    }
    write(program, example, out / program.label);
  }
  fmt::print("{} programs\n", programs.size());
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 2;
}

// apply_mutant MUTANT.toml ROOT FOLDER: writes into FOLDER the sources of the project at ROOT that the mutant changes,
// changed, under their own paths. What is there already and the same is left alone, so that nothing is compiled for it.

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "conformance/mutants/mutant.h"

namespace {

namespace fs = std::filesystem;

bool holds(const fs::path& file, const std::string& text) {
  std::ifstream stream(file, std::ios::binary);
  return stream && std::string(std::istreambuf_iterator<char>(stream), {}) == text;
}

void write(const fs::path& file, const std::string& text) {
  if (holds(file, text)) return;
  fs::create_directories(file.parent_path());
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  if (!stream.flush()) throw std::runtime_error("cannot write " + file.string());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fputs("usage: apply_mutant MUTANT.toml ROOT FOLDER\n", stderr);
    return 2;
  }
  try {
    const plumb::Mutant mutant = plumb::read_mutant(argv[1]);
    for (const std::string& file : mutant.files()) {
      // Messages of the compiler name the source that a person edits.
      const std::string line = "#line 1 \"" + file + "\"\n";
      write(fs::path(argv[3]) / file, line + plumb::mutated_source(mutant, file, argv[2]));
    }
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[1], error.what());
    return 2;
  }
}

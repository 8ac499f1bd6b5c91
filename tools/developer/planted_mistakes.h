#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "conformance/mutants/mutant.h"

namespace plumb {

/// The files of a program: their texts by their paths, relative to the project's root, with '/'.
using SourceTree = std::map<std::string, std::string>;

/// A change to be planted in a program that shares no code with the renderer: a mistake, to see whether its pictures
/// are recognised (docs/diagnosis.md), or another right way to do the same, to see that they are not found fault with
/// (docs/envelopes.md).
struct PlantedMistake {
  /// The name of its file without the ending.
  std::string id;
  std::string name;
  /// Known bugs, any of which is the right name for it; empty if it is none of the known ones, or no mistake.
  std::vector<std::string> same_as;
  std::vector<Edit> edits;
};

/// Every `*.toml` of the folder, in order of id. Throws InputError at the value at fault: malformed, a key that is
/// unknown or missing, no edit; and if there is no file, or if they change more than one of the examples.
std::vector<PlantedMistake> read_planted_mistakes(const std::filesystem::path& folder);

/// The program that the mistakes are planted in, relative to the project's root: `examples/NAME`. At least one mistake.
std::string program_of(const std::vector<PlantedMistake>& mistakes);

/// The file's text. Throws InputError if it cannot be opened.
std::string read_source(const std::filesystem::path& file);

/// Every file of the program. Throws InputError if there is none.
SourceTree read_sources(const std::filesystem::path& root, const std::string& program);

/// The files with all edits made, in their order. Throws InputError, naming the edit's file, if it is not there or a
/// `find` does not occur exactly once.
SourceTree plant(const PlantedMistake& mistake, SourceTree sources);

/// The text of a C++ program that computes in floats what it computed in doubles, with rays that start 1e-4 from their
/// surface, as a float program's must. Made for examples/cpp-correct: std::max and std::min of a literal are taken care
/// of, other mixed calls are not.
std::string in_single_precision(std::string text);

/// A program to be built: its sources, and what is planted in them.
struct PlantedProgram {
  /// `ID`, `ID+ID`; the end `-float` for single precision.
  std::string label;
  SourceTree sources;
  std::vector<PlantedMistake> mistakes;
};

/// One program for each mistake.
std::vector<PlantedProgram> single_programs(const std::vector<PlantedMistake>& mistakes, const SourceTree& sources);

/// `count` different pairs, drawn by the seed from those that have a name each, share none, and can both be planted.
/// Fewer if there are fewer.
std::vector<PlantedProgram> pair_programs(const std::vector<PlantedMistake>& mistakes, const SourceTree& sources,
                                          std::size_t count, std::uint64_t seed);

}  // namespace plumb

#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace plumb {

/// A change of a source file: `find` stands in it exactly once, and `replace` takes its place.
struct PlantedEdit {
  /// Relative to the project's root, with '/'.
  std::string file;
  std::string find;
  std::string replace;
};

/// A mistake to be planted in a program that shares no code with the renderer, to see whether its pictures are
/// recognised (docs/diagnosis.md).
struct PlantedMistake {
  /// The name of its file without the ending.
  std::string id;
  std::string name;
  /// Known bugs, any of which is the right name for it; empty if it is none of the known ones.
  std::vector<std::string> same_as;
  std::vector<PlantedEdit> edits;
};

/// Every `*.toml` of the folder, in order of id. Throws InputError at the value at fault: malformed, a key that is
/// unknown or missing, no edit; and if there is no file, or if not all change the same source.
std::vector<PlantedMistake> read_planted_mistakes(const std::filesystem::path& folder);

/// The text with all edits made, in their order. Throws InputError, naming the edit's file, if a `find` does not occur
/// exactly once.
std::string plant(const PlantedMistake& mistake, std::string text);

/// The text of a C++ program that computes in floats what it computed in doubles, with rays that start 1e-4 from their
/// surface, as a float program's must. Made for examples/cpp-correct: std::max and std::min of a literal are taken care
/// of, other mixed calls are not.
std::string in_single_precision(std::string text);

/// A program to be built: its source, and what is planted in it.
struct PlantedProgram {
  /// `ID`, `ID+ID`; the end `-float` for single precision.
  std::string label;
  std::string source;
  std::vector<PlantedMistake> mistakes;
};

/// One program for each mistake.
std::vector<PlantedProgram> single_programs(const std::vector<PlantedMistake>& mistakes, const std::string& source);

/// `count` different pairs, drawn by the seed from those that have a name each, share none, and can both be planted.
/// Fewer if there are fewer.
std::vector<PlantedProgram> pair_programs(const std::vector<PlantedMistake>& mistakes, const std::string& source,
                                          std::size_t count, std::uint64_t seed);

}  // namespace plumb

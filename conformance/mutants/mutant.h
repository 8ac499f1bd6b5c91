#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// A change of one source file: `find` stands in it exactly once, and `replace` takes its place.
struct Edit {
  /// Relative to the project's root, with '/'.
  std::string file;
  std::string find;
  std::string replace;
};

/// A known bug: a mistake that students make, planted in the renderer (docs/known-bugs.md).
struct Mutant {
  /// The name of its file without the ending, `rotate-x-by-z`.
  std::string id;
  /// What a student would call the mistake; a sentence without its full stop.
  std::string name;
  /// What a teacher would say, in one or two sentences.
  std::string hint;
  /// The step of the assignment it belongs to, one of mutant_steps().
  std::string step;
  /// Whether a program with the mistake shows it only here and there, where its own order of search has it: the mutant
  /// shows it everywhere.
  bool in_places = false;
  /// At least one.
  std::vector<Edit> edits;
  /// Cases of suites/pa3.toml, and `check:ID` for a check: each alone must notice the mistake. Empty only where one of
  /// the next two is not.
  std::vector<std::string> caught_by;
  /// The variant that the suite accepts and that this equals, or empty.
  std::string accepted;
  /// Why no picture can differ, or empty.
  std::string equivalent;

  /// The files that its edits change, each once, in the order in which they are named.
  std::vector<std::string> files() const;
};

/// The steps of the assignment, in its order.
std::span<const std::string_view> mutant_steps();

/// Reads `ID.toml`. Throws InputError at the value at fault: malformed, a key that is unknown or missing, an empty
/// text, an unknown step, an edit that changes nothing, a mutant that nothing has to catch.
Mutant read_mutant(const std::filesystem::path& file);

/// Every `*.toml` of the folder, in the order of ids. Throws as read_mutant; and InputError if there is none, or if two
/// have the same name or hint.
std::vector<Mutant> read_mutants(const std::filesystem::path& folder);

/// The text with the edit made. Throws InputError, naming `edit.file`, if `find` does not occur in it exactly once:
/// then the source has moved on, and the mutant has to follow it.
std::string apply(const Edit& edit, std::string text);

/// A source file of the project, read below `root`, with all of the mutant's edits of it made in their order. Throws
/// InputError if it cannot be read, or as apply.
std::string mutated_source(const Mutant& mutant, std::string_view file, const std::filesystem::path& root);

}  // namespace plumb

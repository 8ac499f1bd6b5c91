#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace plumb {

/// What one case or check says of one program with a known mistake.
enum class Notice {
  not_asked,   ///< a check or growth case that the mutant does not name
  right,       ///< nothing is wrong
  warning,     ///< right with a warning: single pixels, a slight bias
  by_variant,  ///< wrong by some of the suite's variants, right by another
  undecided,   ///< the check cannot say: not supported, or no decision in its time
  wrong,
  no_picture,  ///< a crash, no end, nothing that can be read
};

/// Whether the mistake is noticed by this alone, whatever the suite accepts.
constexpr bool is_noticed(Notice notice) { return notice == Notice::wrong || notice == Notice::no_picture; }

/// As it stands in files: `no_picture`.
constexpr const char* to_string(Notice notice) {
  constexpr const char* kNames[] = {"not_asked", "right", "warning", "by_variant", "undecided", "wrong", "no_picture"};
  return kNames[static_cast<int>(notice)];
}

/// A place of the kill matrix.
struct ScoreCell {
  Notice notice = Notice::not_asked;
  /// Whether the mutant names the case or check as one that has to notice it.
  bool named = false;
  /// kind image: by the suite's first variant, with the case's tolerance. 0 where there is no picture.
  std::int64_t wrong_pixels = 0;
  /// Its finding, one line; empty where nothing is wrong or nothing was asked.
  std::string found;
};

/// A case of the suite, or a check of `plumb check`.
struct ScoreColumn {
  /// As mutants name it: `sphere`, `growth-trace`, `check:S0`.
  std::string id;
  /// image, growth or check
  std::string kind;
  /// What it says of the tracer without mistakes, where that is not right: a fault of ours, so that what it says of
  /// mutants counts for nothing. Empty where all is well.
  std::string fault;
  /// How many mutants it notices; and of a case, the ids of those that no other case of the suite does.
  int noticed = 0;
  std::vector<std::string> only_here;
};

/// What the suite makes of one mutant.
enum class MutantVerdict {
  caught,          ///< by all that it names
  partly_caught,   ///< by some of what it names
  elsewhere,       ///< only by what it does not name
  survives,        ///< nothing notices it
  accepted,        ///< right by the variant that it names, in every case
  not_accepted,    ///< it names a variant by which it is not right
  equivalent,      ///< right in every case, as it says
  not_equivalent,  ///< it calls itself equivalent and is not
};

/// As it stands in files: `partly_caught`.
constexpr const char* to_string(MutantVerdict verdict) {
  constexpr const char* kNames[] = {"caught",   "partly_caught", "elsewhere",  "survives",
                                    "accepted", "not_accepted",  "equivalent", "not_equivalent"};
  return kNames[static_cast<int>(verdict)];
}

/// Whether the suite does with such a mutant what it has to.
constexpr bool is_settled(MutantVerdict verdict) {
  return verdict == MutantVerdict::caught || verdict == MutantVerdict::accepted || verdict == MutantVerdict::equivalent;
}

struct ScoreRow {
  std::string id, name, step;
  /// The variant that it claims to equal; empty for none.
  std::string variant;
  MutantVerdict verdict = MutantVerdict::survives;
  /// One a column.
  std::vector<ScoreCell> cells;
  /// What does not hold of what the mutant claims, a sentence each. Empty exactly if it is settled.
  std::vector<std::string> missing;
};

/// The kill matrix of a suite: mutants by cases and checks (docs/pa3-suite.md).
struct SuiteScore {
  std::string suite_id, suite_hash, plumb_version;
  /// Of checks and growth cases.
  std::uint64_t seed = 1;
  double intensity = 1;
  /// The suite's cases in its order, then checks by name.
  std::vector<ScoreColumn> columns;
  /// In the order of the assignment's steps, then by id.
  std::vector<ScoreRow> rows;

  int count(MutantVerdict verdict) const;
  /// Mutants that are meant to be caught: neither accepted nor equivalent, nor said to be.
  int to_catch() const;
  /// 3 if a case or check is at fault with the tracer without mistakes, else 1 if a mutant is not settled, else 0.
  int exit_status() const;
};

}  // namespace plumb

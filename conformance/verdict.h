#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace plumb {

/// What was found of one case (docs/results.md).
enum class Verdict {
  pass,
  quality_warning,  ///< right, with something to look at
  fail,
  timeout,
  memory_limit,
  output_limit,
  crash,
  security,     ///< a link, an escape, or a changed build
  unsupported,  ///< the subject lacks it
  skipped,      ///< a prerequisite failed
  internal_error,
};

/// As it stands in results: `quality_warning`.
std::string_view to_string(Verdict verdict);

/// Whether it earns its points: pass or quality_warning.
bool is_right(Verdict verdict);

/// The exit status of a command with these verdicts: 3 if any is internal_error, else 1 if any is not right, else 0.
int exit_status(std::span<const Verdict> verdicts);

/// One measured fact behind a verdict.
using EvidenceValue = std::variant<std::int64_t, double, std::string>;
using Evidence = std::vector<std::pair<std::string, EvidenceValue>>;

/// What a check found. No time or memory that was measured, no host and no absolute path stands in it: those belong to
/// the run's usage, so that the same subject gives the same result.
struct CheckResult {
  Verdict verdict = Verdict::internal_error;
  /// Why, in one word that does not change: `no_picture`, `wrong_size`, `cpu_time`; empty for a plain pass.
  std::string cause;
  /// The signed distance to the threshold, positive on the right side, in the threshold's unit; nothing where the check
  /// did not get so far, or the distance is a measured time or memory.
  std::optional<double> margin;
  Evidence evidence;
  /// The evidence in one line, for people.
  std::string summary;
  /// One line of what to do; empty for a plain pass.
  std::string advice;
};

}  // namespace plumb

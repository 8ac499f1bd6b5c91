#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "conformance/checks/check.h"
#include "conformance/results/write_results.h"

namespace plumb {

/// The checks whose id matches a GLOB, or one of several parted by commas; all for an empty one. Throws InputError,
/// naming the nearest id, if none matches.
std::vector<const CheckKind*> selected_checks(std::string_view filter);

/// Asks one check, with the other doors at rest, at the first of a subject's doors that can answer (by
/// CheckKind::probe_first from the last on). Exceptions of the subject become verdicts.
CheckResult ask_check(const CheckKind& check, std::span<Subject* const> doors, const CheckOptions& options);

struct ChecksRequest {
  std::vector<const CheckKind*> checks;
  CheckOptions options;
  /// The words that repeat the run, without --filter and --seed: `plumb check embree`.
  std::string command;
  std::string subject_id;
  std::string plumb_version;
  /// Told the check that begins, and then the share of it that is done.
  std::function<void(const CheckKind&, double)> progress = [](const CheckKind&, double) {};
  /// Told each result as it comes.
  std::function<void(const CaseResult&)> done = [](const CaseResult&) {};
};

/// Runs the checks one after the other, a point each. What the subject does wrong in one does not touch the next. An
/// interrupt (interrupt_flag) leaves the rest skipped, pending.
ResultSet run_checks(const ChecksRequest& request, std::span<Subject* const> doors);

/// Several checks as one: the verdict of the worst (internal_error, a failure in the order of the checks, unsupported,
/// quality_warning, pass), with each one's verdict as evidence.
CheckResult combined(std::span<const CheckKind* const> checks, std::span<const CheckResult> results);

}  // namespace plumb

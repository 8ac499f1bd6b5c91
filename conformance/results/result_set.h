#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "conformance/results/diagnosis_results.h"
#include "conformance/results/growth_results.h"
#include "conformance/sandbox/run_outcome.h"
#include "conformance/verdict.h"

namespace plumb {

/// One case of a suite, judged for one submission.
struct CaseResult {
  std::string id;
  std::string kind;
  std::string requirement;
  std::string visibility;
  CheckResult check;
  /// kind image, judged by envelopes: the result by each of the suite's variants; `check` is one of them.
  std::vector<CheckResult> by_variant;
  /// Points earned, out of max_points. A pending case waits for a person: its points count neither way.
  double points = 0;
  double max_points = 0;
  bool pending = false;
  /// Left out of the totals, by the suite's rule for skipped cases.
  bool excluded = false;
  /// SHA-256 of the input files by name, and of `reference` and `picture` as far as they were looked at.
  std::vector<std::pair<std::string, std::string>> input_hashes;
  std::vector<std::pair<std::string, std::string>> hashes;
  /// Of what decides the case by chance.
  std::optional<std::uint64_t> seed;
  /// What repeats this case.
  std::string repeat;
  /// The run, where there was one; everything in it was measured.
  std::optional<RunOutcome> run;
  /// kind growth: what the gate measured.
  std::optional<GrowthFigures> growth;
  /// For internal_error: what went wrong, with the paths and whatever else differs from machine to machine.
  std::string internal_message;
  /// Distance to a limit of time or memory; stands beside the measurements.
  std::optional<double> measured_margin;
};

struct Totals {
  double points = 0;
  double max_points = 0;
  double pending_points = 0;
};

/// Everything that grading one submission by one suite found.
struct ResultSet {
  std::string suite_id;
  std::string suite_hash;
  std::string dialect;
  /// The ids of the accepted variants, and the one that the submission was judged by; empty where no case has
  /// envelopes.
  std::vector<std::string> variants;
  std::string variant;
  std::string submission_id;
  std::string plumb_version;
  /// Sentences about the submission as a whole: files left out, a configuration ignored.
  std::vector<std::string> notes;
  /// Which known mistakes account for the wrong pictures; nothing where none is wrong or nothing is known of the suite.
  std::optional<Diagnosis> diagnosis;
  /// In the suite's order.
  std::vector<CaseResult> cases;

  Totals totals() const;
};

}  // namespace plumb

#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "conformance/judge/suite.h"
#include "conformance/judge/workspace.h"
#include "conformance/results/result_set.h"
#include "conformance/results/write_results.h"

namespace plumb {

/// The growth gates of one submission: cases of kind growth that ask about the same scenes share one
/// (docs/growth-gate.md).
class GrowthGates {
 public:
  /// `progress` is told what is measured.
  explicit GrowthGates(std::function<void(const std::string&)> progress);
  ~GrowthGates();
  GrowthGates(const GrowthGates&) = delete;
  GrowthGates& operator=(const GrowthGates&) = delete;

  /// Runs the gate of a case of kind growth unless an earlier case did, and says what it found for this one. Each run
  /// is in a fresh folder with files of random names, and its picture is checked; a wrong one, a crash and the like are
  /// the verdict. What was measured goes to `result.growth`. Undecided is internal_error with the cause `undecided`.
  /// Throws only where the fault is ours.
  void judge(const SuiteCase& suite_case, const Runner& runner, Workspace& workspace, double seconds_left,
             const ResultFolder& results, CaseResult& result);

 private:
  struct Gate;
  std::function<void(const std::string&)> progress_;
  std::vector<std::unique_ptr<Gate>> gates_;
};

}  // namespace plumb

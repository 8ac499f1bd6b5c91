#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "conformance/judge/suite.h"
#include "conformance/results/write_results.h"
#include "conformance/sandbox/run_outcome.h"
#include "conformance/verdict.h"

namespace plumb {

/// What the image check looks at, once every process of the run has ended.
struct ImageCheckInput {
  const SuiteCase& suite_case;
  const RunOutcome& run;
  /// Where the program ran, and the picture relative to it.
  std::filesystem::path run_folder;
  std::string output;
  /// Where the picture, its reference and the heat map of their difference go.
  std::filesystem::path evidence_folder;
};

struct ImageCheck {
  /// By envelopes: the best of `by_variant`, the first of several.
  CheckResult result;
  /// By envelopes: one for each variant of the suite. Empty where there was no picture to compare.
  std::vector<CheckResult> by_variant;
  /// Of the picture and the reference, by name.
  std::vector<std::pair<std::string, std::string>> hashes;
};

/// Whether the program wrote the picture that the case asks for. The picture is taken out by descriptor, never through
/// a link (`security`), and judged by the case's envelopes (judge_findings), or where it has none by judge_picture; no
/// picture at all is `no_picture`. A right picture from a program with an exit status other than 0 is a quality_warning
/// (`exit_status`).
ImageCheck check_image(const ImageCheckInput& input);

}  // namespace plumb

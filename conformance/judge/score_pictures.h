#pragma once

#include <string>
#include <vector>

#include "conformance/diagnosis/fingerprint.h"
#include "conformance/envelopes/envelope.h"
#include "conformance/judge/suite.h"
#include "conformance/results/score_results.h"

namespace plumb {

/// One case of a built suite, against the pictures of known mistakes.
class PictureScorer {
 public:
  /// `suite_case` has an envelope for each of the variants. Throws as read_envelope.
  PictureScorer(const SuiteCase& suite_case, const std::vector<Variant>& variants);

  /// Judges the picture by each variant, as grading does. Where the fingerprint has none, the program drew what the
  /// first variant holds for right. Throws InputError for a picture that cannot be read or is of another size. Safe
  /// from several threads.
  ScoreCell judge(const Fingerprint& fingerprint) const;

 private:
  std::string id_;
  double tolerance_;
  /// Each once, the first variant's in front, and the first of the variants that it stands for.
  std::vector<Envelope> envelopes_;
  std::vector<std::string> variants_;
};

}  // namespace plumb

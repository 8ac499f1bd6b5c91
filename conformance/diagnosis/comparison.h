#pragma once

#include <span>
#include <vector>

#include "conformance/diagnosis/deviation.h"
#include "conformance/diagnosis/diagnose.h"
#include "conformance/diagnosis/fingerprint.h"
#include "conformance/diagnosis/likeness.h"

namespace plumb {

/// A submission's pictures, ready to be held against those of known mistakes: the cases that have one.
class Comparison {
 public:
  /// Throws std::invalid_argument for levels of another size than the envelope's.
  explicit Comparison(std::span<const DiagnosisCase> cases);

  std::span<const DiagnosisCase> cases() const { return cases_; }
  const EvidenceLimits& limits(std::size_t i) const { return limits_[i]; }
  std::span<const Deviation> deviations() const { return deviations_; }
  /// Whether enough of some case is wrong that it says something.
  bool shows_something() const { return shows_something_; }

  /// The mistake beside the submission, and then the same under each of the changes, which are put on top of what it
  /// draws; the picture of a case is read once. Throws InputError for one that cannot be read or has another size.
  std::vector<MistakeMatches> matches(const Fingerprint& mistake, std::span<const PictureChange> changes = {}) const;
  /// How alike the pictures of two mistakes are.
  double likeness_of(const Fingerprint& a, const Fingerprint& b) const;

  /// What a program with the mistake draws in case i, with the change on top if there is one.
  std::vector<std::uint8_t> levels(const Fingerprint& mistake, std::size_t i, const PictureChange* change) const;

 private:
  std::vector<DiagnosisCase> cases_;
  std::vector<EvidenceLimits> limits_;
  std::vector<Deviation> deviations_;
  bool shows_something_ = false;
};

}  // namespace plumb

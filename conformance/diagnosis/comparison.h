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

  /// The mistake beside the submission. Throws InputError for a picture that cannot be read or has another size.
  MistakeMatches matches(const Fingerprint& mistake) const { return matches(mistake, deviations_, nullptr); }
  /// The same of two mistakes, the second of which changes every picture.
  MistakeMatches matches(const Fingerprint& mistake, const PictureChange& change) const {
    return matches(mistake, deviations_, &change);
  }
  /// How alike the pictures of two mistakes are.
  double likeness_of(const Fingerprint& a, const Fingerprint& b) const;

  /// What a program with the mistake draws in case i, and with the change on top if there is one.
  std::vector<std::uint8_t> levels(const Fingerprint& mistake, std::size_t i, const PictureChange* change) const;

 private:
  MistakeMatches matches(const Fingerprint& mistake, std::span<const Deviation> deviations,
                         const PictureChange* change) const;

  std::vector<DiagnosisCase> cases_;
  std::vector<EvidenceLimits> limits_;
  std::vector<Deviation> deviations_;
  bool shows_something_ = false;
};

}  // namespace plumb

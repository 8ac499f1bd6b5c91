#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "conformance/diagnosis/fingerprint.h"
#include "conformance/envelopes/envelope.h"
#include "conformance/results/diagnosis_results.h"

namespace plumb {

/// One image case of a suite, as a submission answered it.
struct DiagnosisCase {
  std::string id;
  /// Of the variant that the submission fits best; not null, and kept by the caller.
  const Envelope* envelope = nullptr;
  /// Levels that are allowed beyond the envelope.
  int tolerance = 1;
  /// The submission's picture, three bytes a pixel, of the envelope's size. Empty where there is none to compare (a
  /// crash, no picture, another size): the case says nothing.
  std::span<const std::uint8_t> levels;
};

/// Compares a submission's wrong pictures with those of known mistakes, over all cases at once. `findings` are
/// suspicions that were come by otherwise (a picture that is mirrored as a whole): they are ranked with the rest, by
/// their likeness. Throws InputError for a fingerprint's picture that cannot be read or has another size than the
/// case's envelope; std::invalid_argument for levels of another size.
Diagnosis diagnose(std::span<const DiagnosisCase> cases, std::span<const Fingerprint> fingerprints,
                   std::span<const Suspicion> findings = {});

}  // namespace plumb

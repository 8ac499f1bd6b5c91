#pragma once

#include <span>
#include <vector>

#include "conformance/diagnosis/comparison.h"
#include "conformance/results/diagnosis_results.h"

namespace plumb {

/// What a program with a suspected mistake draws: the mistake's pictures, with a change on top if there is one.
struct SuspectedDrawing {
  const Fingerprint* mistake = nullptr;
  const PictureChange* change = nullptr;
};

/// The pixels that show best that a submission has the mistakes, at most three: one of a case, first that of the case
/// where each drawing agrees most with the submission, then of the cases where any agrees most. In a case it is, among
/// the pixels where the two agree, with as many neighbours as possible that do, the one that is off most; of equals the
/// first, row by row. None if they agree nowhere.
std::vector<DiagnosisPixel> evidence_pixels(const Comparison& comparison, std::span<const SuspectedDrawing> drawings);

}  // namespace plumb

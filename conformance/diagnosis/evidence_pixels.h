#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "conformance/diagnosis/deviation.h"
#include "conformance/diagnosis/diagnose.h"

namespace plumb {

/// The pixel that shows best that a submission has the mistake whose picture of the same case is `suspected`: among
/// those where the two agree, with as many neighbours as possible that do, the one that is off most; of equals the
/// first, row by row. Nothing if they agree nowhere.
std::optional<DiagnosisPixel> evidence_pixel(const DiagnosisCase& picture, const EvidenceLimits& limits,
                                             const Deviation& deviation, std::span<const std::uint8_t> suspected);

}  // namespace plumb

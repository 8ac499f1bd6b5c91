#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "conformance/compare/wrong_regions.h"
#include "conformance/envelopes/envelope.h"
#include "conformance/verdict.h"
#include "renderer/image/picture.h"

namespace plumb {

/// How a picture lies in an envelope.
struct EnvelopeFindings {
  /// By PixelReason: how many pixels there are, and how many have a channel outside of its interval by more than the
  /// tolerance.
  std::array<std::int64_t, kPixelReasons> pixels{}, wrong{};
  PixelMask mask;
  WrongRegions regions;
  /// The largest distance of a channel from its interval, in levels, and the first pixel that has it.
  double worst = 0;
  int worst_x = 0, worst_y = 0;
  /// Interior samples (pixel and channel) above and below the reference.
  std::int64_t above = 0, below = 0;

  std::int64_t wrong_pixels() const;
};

/// `picture` has the envelope's size and finite samples in levels.
EnvelopeFindings compare_with_envelope(const Picture& picture, const Envelope& envelope, double tolerance);

/// The verdict, with its evidence. `different`: a pixel is outside of its interval by more than the tolerance, unless
/// the wrong pixels are isolated: at most kMostIsolated of them (or kIsolatedShare of all, if that is more), no three
/// together. Those are a quality_warning (`isolated_pixels`): cracks between triangles, or acne. `bias`, a
/// quality_warning too: of the interior samples that are off, at least kBiasShare of all, so many more are off to one
/// side that by chance it would happen once in 1e9 pictures (sign test, normal approximation of the binomial: 6 sigma).
/// `transparent` as judge_picture.
CheckResult judge_findings(const EnvelopeFindings& findings, const Picture& picture, const Envelope& envelope,
                           double tolerance);

constexpr std::int64_t kMostIsolated = 3;
constexpr double kIsolatedShare = 1e-4;
constexpr double kBiasShare = 0.01;
constexpr double kBiasSigma = 6.1;

}  // namespace plumb

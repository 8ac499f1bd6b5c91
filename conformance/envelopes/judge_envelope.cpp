#include "conformance/envelopes/judge_envelope.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plumb {
namespace {

/// `12 13 14`, or `12-15 13 14` where a channel has an interval.
std::string expected_text(const Envelope& envelope, std::size_t pixel) {
  std::string text;
  for (std::size_t c = 3 * pixel; c < 3 * pixel + 3; ++c) {
    if (!text.empty()) text += " ";
    text += envelope.low[c] == envelope.high[c] ? fmt::format("{}", envelope.low[c])
                                                : fmt::format("{}-{}", envelope.low[c], envelope.high[c]);
  }
  return text;
}

std::string found_text(const Picture& picture, std::size_t pixel) {
  const float* p = picture.samples.data() + 3 * pixel;
  return fmt::format("{:g} {:g} {:g}", p[0], p[1], p[2]);
}

/// How many standard deviations the signs of the deviations are from as many above as below.
double bias_sigma(const EnvelopeFindings& f) {
  const double n = static_cast<double>(f.above + f.below);
  return n == 0 ? 0 : std::abs(static_cast<double>(f.above - f.below)) / std::sqrt(n);
}

bool is_biased(const EnvelopeFindings& f) {
  const auto samples = static_cast<double>(3 * f.pixels[0]);
  return static_cast<double>(f.above + f.below) >= kBiasShare * samples && bias_sigma(f) > kBiasSigma;
}

bool is_isolated(const EnvelopeFindings& f, std::size_t pixels) {
  const double most = std::max(static_cast<double>(kMostIsolated), kIsolatedShare * static_cast<double>(pixels));
  return static_cast<double>(f.wrong_pixels()) <= most && f.regions.largest_blob.wrong < 3;
}

Evidence evidence_of(const EnvelopeFindings& f, const Picture& picture, const Envelope& envelope, double tolerance) {
  Evidence evidence{{"pixels", static_cast<std::int64_t>(envelope.pixels())},
                    {"pixels_wrong", f.wrong_pixels()},
                    {"tolerance", tolerance},
                    {"undecidable_pixels", static_cast<std::int64_t>(envelope.pixels()) - f.pixels[0]}};
  for (std::size_t r = 0; r < kPixelReasons; ++r)
    if (f.wrong[r] > 0) {
      std::string name = "wrong_" + std::string(to_string(static_cast<PixelReason>(r)));
      std::ranges::replace(name, ' ', '_');
      evidence.emplace_back(name, f.wrong[r]);
    }
  if (f.wrong_pixels() > 0) {
    const auto at = static_cast<std::size_t>(f.worst_y) * static_cast<std::size_t>(envelope.width) +
                    static_cast<std::size_t>(f.worst_x);
    evidence.insert(evidence.end(), {{"largest_blob", f.regions.largest_blob.wrong},
                                     {"max_difference", f.worst},
                                     {"max_x", std::int64_t{f.worst_x}},
                                     {"max_y", std::int64_t{f.worst_y}},
                                     {"expected", expected_text(envelope, at)},
                                     {"found", found_text(picture, at)}});
  }
  return evidence;
}

CheckResult with_warning(CheckResult result, const std::string& cause, const std::string& advice) {
  result.verdict = Verdict::quality_warning;
  result.cause = cause;
  result.advice = advice;
  return result;
}

}  // namespace

std::int64_t EnvelopeFindings::wrong_pixels() const {
  return std::accumulate(wrong.begin(), wrong.end(), std::int64_t{0});
}

EnvelopeFindings compare_with_envelope(const Picture& picture, const Envelope& envelope, double tolerance) {
  EnvelopeFindings f;
  f.mask = {envelope.width, envelope.height, std::vector<std::uint8_t>(envelope.pixels())};
  for (std::size_t p = 0; p < envelope.pixels(); ++p) {
    const auto reason = static_cast<std::size_t>(envelope.reasons[p]);
    double outside = 0;
    for (std::size_t i = 3 * p; i < 3 * p + 3; ++i) {
      const double v = static_cast<double>(picture.samples[i]);
      outside = std::max({outside, envelope.low[i] - v, v - envelope.high[i]});
      if (reason == 0) f.above += v > envelope.nominal[i], f.below += v < envelope.nominal[i];
    }
    ++f.pixels[reason];
    if (outside > tolerance) ++f.wrong[reason], f.mask.wrong[p] = 1;
    if (outside > f.worst) {
      f.worst = outside;
      f.worst_x = static_cast<int>(p % static_cast<std::size_t>(envelope.width));
      f.worst_y = static_cast<int>(p / static_cast<std::size_t>(envelope.width));
    }
  }
  if (f.wrong_pixels() > 0) f.regions = wrong_regions(f.mask);
  return f;
}

CheckResult judge_findings(const EnvelopeFindings& f, const Picture& picture, const Envelope& envelope,
                           double tolerance) {
  CheckResult result;
  result.verdict = Verdict::pass;
  result.margin = tolerance - f.worst;
  result.evidence = evidence_of(f, picture, envelope, tolerance);
  const std::int64_t wrong = f.wrong_pixels();
  const auto at = static_cast<std::size_t>(f.worst_y) * static_cast<std::size_t>(envelope.width) +
                  static_cast<std::size_t>(f.worst_x);
  if (wrong > 0) {
    result.summary = fmt::format("{} of {} pixels are no right answer, the worst by {:g} levels", wrong,
                                 envelope.pixels(), f.worst + 0.0);
    const std::string look = fmt::format("look at pixel ({},{}): expected {}, found {}", f.worst_x, f.worst_y,
                                         expected_text(envelope, at), found_text(picture, at));
    if (is_isolated(f, envelope.pixels())) return with_warning(result, "isolated_pixels", look);
    result.verdict = Verdict::fail;
    result.cause = "different";
    result.advice = look;
    return result;
  }
  result.summary = fmt::format("all {} pixels are right ({} with a choice)", envelope.pixels(),
                               static_cast<std::int64_t>(envelope.pixels()) - f.pixels[0]);
  if (picture.transparent)
    return with_warning(result, "transparent",
                        "the colours are right, but some pixels are transparent: write an opaque picture");
  if (is_biased(f))
    return with_warning(
        result, "bias",
        fmt::format("{} channels are a little too bright and {} too dark: is a colour rounded to the nearest level?",
                    f.above, f.below));
  return result;
}

}  // namespace plumb

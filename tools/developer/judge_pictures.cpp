#include "tools/developer/judge_pictures.h"

#include <algorithm>
#include <numeric>

#include "conformance/compare/judge_picture.h"
#include "conformance/envelopes/judge_envelope.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

std::int64_t moved(const Picture& picture, const Envelope& envelope) {
  std::int64_t count = 0;
  for (std::size_t p = 0; p < envelope.pixels(); ++p) {
    if (envelope.reasons[p] == PixelReason::interior) continue;
    bool differs = false;
    for (std::size_t i = 3 * p; i < 3 * p + 3; ++i) differs |= picture.samples[i] != envelope.nominal[i];
    count += differs;
  }
  return count;
}

JudgedPicture judged(const SuiteCase& c, const fs::path& envelope_folder, const Picture& picture) {
  const Envelope envelope = read_envelope(envelope_folder);
  const EnvelopeFindings findings = compare_with_envelope(picture, envelope, c.tolerance);
  return {c.id, judge_findings(findings, picture, envelope, c.tolerance), findings.wrong_pixels(),
          moved(picture, envelope)};
}

}  // namespace

std::int64_t JudgedPictures::wrong_pixels() const {
  return std::accumulate(cases.begin(), cases.end(), std::int64_t{0},
                         [](std::int64_t sum, const JudgedPicture& p) { return sum + p.wrong_pixels; });
}

std::int64_t JudgedPictures::moved_pixels() const {
  return std::accumulate(cases.begin(), cases.end(), std::int64_t{0},
                         [](std::int64_t sum, const JudgedPicture& p) { return sum + p.moved_pixels; });
}

JudgedPictures judge_pictures(const Suite& built, const fs::path& folder) {
  std::vector<JudgedPictures> by_variant(built.variants.size());
  for (std::size_t v = 0; v < by_variant.size(); ++v) by_variant[v].variant = built.variants[v].id;
  for (const SuiteCase& c : built.cases) {
    if (c.kind != "image" || c.envelopes.empty()) continue;
    const fs::path file = folder / (c.id + ".png");
    PictureJudgement opened;
    if (fs::exists(file)) opened = open_picture(file, read_reference(c.reference));
    const bool usable = opened.picture && opened.result.verdict == Verdict::pass;
    for (std::size_t v = 0; v < by_variant.size(); ++v) {
      if (!usable)
        by_variant[v].unusable.push_back(c.id);
      else if (v > 0 && c.envelopes[v] == c.envelopes[v - 1])
        by_variant[v].cases.push_back(by_variant[v - 1].cases.back());
      else
        by_variant[v].cases.push_back(judged(c, c.envelopes[v], *opened.picture));
    }
  }
  return *std::ranges::min_element(by_variant, {}, &JudgedPictures::wrong_pixels);
}

}  // namespace plumb

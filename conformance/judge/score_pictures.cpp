#include "conformance/judge/score_pictures.h"

#include <algorithm>

#include "conformance/envelopes/judge_envelope.h"

namespace plumb {
namespace {

Picture picture_of(const StoredPicture& stored, int width, int height) {
  const std::vector<std::uint8_t> levels = stored.levels(width, height);
  Picture picture;
  picture.width = width, picture.height = height;
  picture.samples.assign(levels.begin(), levels.end());
  return picture;
}

}  // namespace

PictureScorer::PictureScorer(const SuiteCase& suite_case, const std::vector<Variant>& variants)
    : id_(suite_case.id), tolerance_(suite_case.tolerance) {
  for (std::size_t v = 0; v < suite_case.envelopes.size(); ++v) {
    const auto first = std::ranges::find(suite_case.envelopes, suite_case.envelopes[v]);
    if (first != suite_case.envelopes.begin() + static_cast<std::ptrdiff_t>(v)) continue;
    envelopes_.push_back(read_envelope(suite_case.envelopes[v]));
    variants_.push_back(variants[v].id);
  }
}

ScoreCell PictureScorer::judge(const Fingerprint& fingerprint) const {
  if (std::ranges::find(fingerprint.no_picture, id_) != fingerprint.no_picture.end())
    return {.notice = Notice::no_picture, .found = "there is no usable picture"};
  const auto stored = fingerprint.pictures.find(id_);
  if (stored == fingerprint.pictures.end()) return {.notice = Notice::right, .found = ""};

  const Picture picture = picture_of(stored->second, envelopes_.front().width, envelopes_.front().height);
  ScoreCell cell{.notice = Notice::wrong, .found = ""};
  for (std::size_t i = 0; i < envelopes_.size(); ++i) {
    const EnvelopeFindings findings = compare_with_envelope(picture, envelopes_[i], tolerance_);
    const CheckResult result = judge_findings(findings, picture, envelopes_[i], tolerance_);
    if (i == 0) cell.wrong_pixels = findings.wrong_pixels(), cell.found = result.summary;
    if (!is_right(result.verdict)) continue;
    cell.notice = i == 0 ? Notice::warning : Notice::by_variant;
    cell.found += i == 0 ? "; a warning only (" + result.cause + ")" : "; right by the variant '" + variants_[i] + "'";
    break;
  }
  return cell;
}

}  // namespace plumb

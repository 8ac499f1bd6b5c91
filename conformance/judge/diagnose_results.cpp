#include "conformance/judge/diagnose_results.h"

#include <algorithm>
#include <cctype>
#include <deque>
#include <map>

#include "conformance/compare/judge_picture.h"
#include "conformance/compare/picture_faults.h"
#include "conformance/diagnosis/diagnose.h"
#include "conformance/envelopes/envelope.h"
#include "conformance/envelopes/judge_envelope.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// A fault of whole pictures is listed where it explains more than it leaves open.
constexpr double kLeastFinding = 0.5;

Picture picture_of(std::span<const std::uint8_t> levels, const Envelope& envelope) {
  Picture picture;
  picture.width = envelope.width, picture.height = envelope.height;
  picture.samples.assign(levels.begin(), levels.end());
  return picture;
}

/// The picture that the program wrote, where it has the right size and is finite; empty otherwise.
std::vector<std::uint8_t> levels_of_case(const CaseResult& result, const Envelope& envelope, const fs::path& folder) {
  if (result.by_variant.empty()) return {};
  for (const char* name : {"picture.png", "picture.ppm"}) {
    if (!fs::exists(folder / name)) continue;
    const Picture picture = read_reference(folder / name);
    if (picture.width != envelope.width || picture.height != envelope.height) return {};
    std::vector<std::uint8_t> levels;
    levels.reserve(picture.samples.size());
    for (const float v : picture.samples) levels.push_back(static_cast<std::uint8_t>(v));
    return levels;
  }
  return {};
}

/// What whole pictures show (mirrored, shifted, without gamma): a suspicion where it explains most of the wrong cases.
/// `missed` stays 0: such a mistake shows in every case, also where a symmetric scene hides it.
std::vector<Suspicion> whole_picture_findings(const std::vector<DiagnosisCase>& cases) {
  std::map<PictureFault, Suspicion> found;
  double wrong_cases = 0;
  for (const DiagnosisCase& c : cases) {
    if (c.levels.empty()) continue;
    const Picture nominal = picture_of(c.envelope->nominal, *c.envelope), picture = picture_of(c.levels, *c.envelope);
    if (compare_with_envelope(picture, *c.envelope, c.tolerance).wrong_pixels() == 0) continue;
    ++wrong_cases;
    for (const FoundFault& fault : picture_faults(nominal, picture, c.tolerance)) {
      Suspicion& s = found[fault.fault];
      s.id = "picture:" + to_string(fault.fault);
      s.name = fault.sentence;
      s.likeness += fault.explained;
    }
  }
  std::vector<Suspicion> findings;
  for (auto& [fault, s] : found) {
    s.likeness = s.explained = s.likeness / wrong_cases;
    s.name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(s.name[0])));
    if (s.likeness >= kLeastFinding) findings.push_back(s);
  }
  return findings;
}

}  // namespace

void diagnose_results(const Suite& suite, const ResultFolder& folder, ResultSet& results) {
  if (suite.fingerprints.empty() || results.variant.empty()) return;
  const bool any_wrong = std::ranges::any_of(
      results.cases, [](const CaseResult& c) { return !c.by_variant.empty() && !is_right(c.check.verdict); });
  if (!any_wrong) return;
  const auto variant = static_cast<std::size_t>(std::ranges::find(suite.variants, results.variant, &Variant::id) -
                                                suite.variants.begin());
  std::deque<Envelope> envelopes;
  std::deque<std::vector<std::uint8_t>> pictures;
  std::vector<DiagnosisCase> cases;
  for (const CaseResult& result : results.cases) {
    const auto c = std::ranges::find(suite.cases, result.id, &SuiteCase::id);
    if (c == suite.cases.end() || c->envelopes.empty()) continue;
    envelopes.push_back(read_envelope(c->envelopes[variant]));
    pictures.push_back(levels_of_case(result, envelopes.back(), folder.case_folder(result.id)));
    cases.push_back({.id = result.id,
                     .envelope = &envelopes.back(),
                     .tolerance = static_cast<int>(c->tolerance),
                     .levels = pictures.back()});
  }
  const std::vector<Fingerprint> fingerprints = read_fingerprints(suite.fingerprints);
  results.diagnosis = diagnose(cases, fingerprints);
  // What a picture shows as a whole is mostly a known mistake too, and then need not be said twice.
  if (!results.diagnosis->confident) results.diagnosis = diagnose(cases, fingerprints, whole_picture_findings(cases));
}

}  // namespace plumb

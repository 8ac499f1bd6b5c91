#include "conformance/judge/diagnose_results.h"

#include <algorithm>
#include <deque>

#include "conformance/compare/judge_picture.h"
#include "conformance/diagnosis/diagnose.h"
#include "conformance/envelopes/envelope.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

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

}  // namespace

void diagnose_results(const Suite& suite, const ResultFolder& folder, ResultSet& results) {
  if (suite.fingerprints.empty() || results.variant.empty()) return;
  const bool any_wrong = std::ranges::any_of(results.cases, [](const CaseResult& c) {
    return !c.by_variant.empty() && !is_right(c.check.verdict);
  });
  if (!any_wrong) return;
  const auto variant = static_cast<std::size_t>(
      std::ranges::find(suite.variants, results.variant, &Variant::id) - suite.variants.begin());
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
  results.diagnosis = diagnose(cases, read_fingerprints(suite.fingerprints));
}

}  // namespace plumb

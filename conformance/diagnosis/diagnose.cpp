#include "conformance/diagnosis/diagnose.h"

#include <algorithm>
#include <set>

#include "conformance/diagnosis/comparison.h"
#include "conformance/diagnosis/evidence_pixels.h"
#include "conformance/diagnosis/pairs.h"

namespace plumb {
namespace {

// Where these come from: docs/diagnosis.md.

/// Less alike is no suspicion.
constexpr double kLeastLikeness = 0.3;
/// Two mistakes this alike in what they draw cannot be told apart.
constexpr double kSameLikeness = 0.95;
/// A suspicion is confident from this likeness on, and by so much ahead of the next that differs from it.
constexpr double kConfidentLikeness = 0.85, kConfidentLead = 0.15;
/// Of two mistakes together, which have more ways to fit by chance.
constexpr double kConfidentPair = 0.9;
/// Of a named pair, before it comes ahead of a single mistake.
constexpr double kPairHandicap = 0.02;
/// From here on one mistake of a pair is listed alone, too.
constexpr double kLikelyAlone = 0.5;
constexpr std::size_t kMostSuspicions = 5, kMostPairs = 3;

/// One line of the list before it is written out: one mistake, two, or a finding from elsewhere.
struct Entry {
  std::vector<std::size_t> mistakes;
  /// Whether the second of the two changes every picture, and so those of the first.
  bool second_on_top = false;
  const Suspicion* finding = nullptr;
  Likeness likeness;
};

class Diagnostician {
 public:
  Diagnostician(const Comparison& comparison, std::span<const Fingerprint> fingerprints)
      : comparison_(comparison), fingerprints_(fingerprints), changes_(likely_changes(comparison, fingerprints)) {
    std::vector<PictureChange> on_top;
    for (const std::size_t i : changes_) on_top.push_back(*fingerprints[i].change);
    for (const Fingerprint& fingerprint : fingerprints) {
      std::vector<MistakeMatches> matches = comparison.matches(fingerprint, on_top);
      changed_.emplace_back();
      for (std::size_t k = 0; k < on_top.size(); ++k)
        changed_.back().push_back(likeness(comparison.deviations(), matches[1 + k]));
      mistakes_.push_back(std::move(matches.front()));
    }
  }

  Diagnosis diagnose(std::span<const Suspicion> findings) const { return listed(ordered_entries(findings)); }

 private:
  std::vector<Entry> ordered_entries(std::span<const Suspicion> findings) const {
    std::vector<Entry> entries;
    std::vector<Likeness> singles;
    for (std::size_t i = 0; i < mistakes_.size(); ++i) {
      singles.push_back(likeness(comparison_.deviations(), mistakes_[i]));
      entries.push_back({{i}, false, nullptr, singles.back()});
      // Not paired: what is a pair already, and what agrees here and there with anything.
      if (!fingerprints_[i].parts.empty() || fingerprints_[i].in_places) singles.back() = {};
    }
    for (const LikelyPair& pair : likely_pairs(comparison_.deviations(), mistakes_, singles, kMostPairs))
      entries.push_back({{pair.mistakes[0], pair.mistakes[1]}, false, nullptr, pair.likeness});
    for (const LikelyPair& pair : likely_changed(changes_, changed_, fingerprints_, singles, kMostPairs))
      entries.push_back({{pair.mistakes[0], pair.mistakes[1]}, true, nullptr, pair.likeness});
    for (const Suspicion& finding : findings)
      entries.push_back({{}, false, &finding, {finding.likeness, finding.explained, finding.missed, {}}});
    std::erase_if(entries, [](const Entry& e) { return e.likeness.value < kLeastLikeness; });
    std::ranges::stable_sort(entries, std::ranges::greater{}, [&](const Entry& e) {
      return e.likeness.value - (parts_of(e).size() > 1 && e.mistakes.size() == 1 ? kPairHandicap : 0);
    });
    return entries;
  }

  /// The ids of the single mistakes in it.
  std::set<std::string> parts_of(const Entry& entry) const {
    std::set<std::string> parts;
    for (const std::size_t i : entry.mistakes) {
      const Fingerprint& f = fingerprints_[i];
      if (f.parts.empty())
        parts.insert(f.id);
      else
        parts.insert(f.parts.begin(), f.parts.end());
    }
    return parts;
  }

  /// Whether the pictures of these cases cannot tell the two apart.
  bool same(const Entry& a, const Entry& b) const {
    if (a.finding || b.finding) return false;
    if (parts_of(a) == parts_of(b)) return true;
    if (a.mistakes.size() != 1 || b.mistakes.size() != 1) return false;
    if (fingerprints_[a.mistakes[0]].in_places || fingerprints_[b.mistakes[0]].in_places) return false;
    return comparison_.likeness_of(fingerprints_[a.mistakes[0]], fingerprints_[b.mistakes[0]]) >= kSameLikeness;
  }

  /// Whether an entry repeats a part of one before it: a single mistake of a pair, which by itself accounts for little.
  /// One that accounts for most of it stays: the other may be an accident.
  bool is_part_of(const Entry& entry, const Entry& earlier) const {
    return entry.likeness.value < kLikelyAlone && !entry.mistakes.empty() &&
           std::ranges::includes(parts_of(earlier), parts_of(entry));
  }

  Diagnosis listed(const std::vector<Entry>& entries) const {
    std::vector<const Entry*> kept;
    Diagnosis diagnosis;
    for (const Entry& entry : entries) {
      if (kept.size() == kMostSuspicions) break;
      const auto twin = std::ranges::find_if(kept, [&](const Entry* k) { return same(*k, entry); });
      if (twin != kept.end()) {
        if (entry.mistakes.size() == 1)
          diagnosis.suspicions[static_cast<std::size_t>(twin - kept.begin())].or_one_of.push_back(
              fingerprints_[entry.mistakes[0]].id);
        continue;
      }
      if (std::ranges::any_of(kept, [&](const Entry* k) { return is_part_of(entry, *k); })) continue;
      kept.push_back(&entry);
      diagnosis.suspicions.push_back(written_out(entry));
    }
    const double least = !kept.empty() && kept[0]->mistakes.size() > 1 ? kConfidentPair : kConfidentLikeness;
    diagnosis.confident = !kept.empty() && kept[0]->likeness.value >= least &&
                          (kept.size() == 1 || kept[0]->likeness.value - kept[1]->likeness.value >= kConfidentLead);
    return diagnosis;
  }

  Suspicion written_out(const Entry& entry) const {
    if (entry.finding) return *entry.finding;
    Suspicion suspicion;
    for (const std::size_t i : entry.mistakes) {
      const Fingerprint& f = fingerprints_[i];
      const bool first = suspicion.id.empty();
      suspicion.id += (first ? "" : "+") + f.id;
      suspicion.name += (first ? "" : "; and: ") + f.name;
      suspicion.hint += (first ? "" : " ") + f.hint;
    }
    const std::set<std::string> parts = parts_of(entry);
    if (parts.size() > 1) suspicion.parts.assign(parts.begin(), parts.end());
    suspicion.likeness = entry.likeness.value;
    suspicion.explained = entry.likeness.explained;
    suspicion.missed = entry.likeness.missed;
    suspicion.pixels = evidence_pixels(comparison_, drawings_of(entry));
    return suspicion;
  }

  std::vector<SuspectedDrawing> drawings_of(const Entry& entry) const {
    const auto& mistakes = entry.mistakes;
    if (entry.second_on_top) return {{&fingerprints_[mistakes[0]], &*fingerprints_[mistakes[1]].change}};
    std::vector<SuspectedDrawing> drawings;
    for (const std::size_t i : mistakes) drawings.push_back({&fingerprints_[i], nullptr});
    return drawings;
  }

  const Comparison& comparison_;
  std::span<const Fingerprint> fingerprints_;
  std::vector<MistakeMatches> mistakes_;
  /// Mistakes that are put on top of all others, and how alike the submission is to each mistake under each of them.
  std::vector<std::size_t> changes_;
  std::vector<std::vector<Likeness>> changed_;
};

}  // namespace

Diagnosis diagnose(std::span<const DiagnosisCase> cases, std::span<const Fingerprint> fingerprints,
                   std::span<const Suspicion> findings) {
  const Comparison comparison(cases);
  if (!comparison.shows_something()) return {};
  return Diagnostician(comparison, fingerprints).diagnose(findings);
}

}  // namespace plumb

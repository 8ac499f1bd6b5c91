#include "conformance/diagnosis/diagnose.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <set>
#include <stdexcept>

#include "conformance/diagnosis/evidence_pixels.h"
#include "conformance/diagnosis/pairs.h"

namespace plumb {
namespace {

// Where these come from: docs/diagnosis.md.

/// A picture says something from this share of wrong pixels on.
constexpr double kLeastWrongShare = 0.001;
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
constexpr std::size_t kMostSuspicions = 5, kMostPairs = 3, kMostPixels = 3;

/// One line of the list before it is written out: one mistake, two, or a finding from elsewhere.
struct Entry {
  std::vector<std::size_t> mistakes;
  const Suspicion* finding = nullptr;
  Likeness likeness;
};

class Diagnostician {
 public:
  Diagnostician(std::span<const DiagnosisCase> cases, std::span<const Fingerprint> fingerprints)
      : fingerprints_(fingerprints) {
    for (const DiagnosisCase& picture : cases) {
      if (picture.levels.empty()) continue;
      if (picture.levels.size() != picture.envelope->nominal.size())
        throw std::invalid_argument("the picture of " + picture.id + " has another size than its envelope");
      cases_.push_back(picture);
      limits_.emplace_back(*picture.envelope, picture.tolerance);
      deviations_.push_back(deviation_of(picture.levels, limits_.back()));
      const double wrong = static_cast<double>(deviations_.back().wrong.count());
      if (wrong > kLeastWrongShare * static_cast<double>(limits_.back().pixels())) shows_something_ = true;
    }
  }

  Diagnosis diagnose(std::span<const Suspicion> findings) {
    if (!shows_something_) return {};
    for (const Fingerprint& fingerprint : fingerprints_) mistakes_.push_back(matches_of(fingerprint, deviations_));
    return listed(ordered_entries(findings));
  }

 private:
  MistakeMatches matches_of(const Fingerprint& fingerprint, std::span<const Deviation> deviations) const {
    MistakeMatches matches;
    for (std::size_t i = 0; i < cases_.size(); ++i) {
      const auto picture = fingerprint.pictures.find(cases_[i].id);
      matches.unknown.push_back(std::ranges::find(fingerprint.no_picture, cases_[i].id) !=
                                fingerprint.no_picture.end());
      matches.cases.emplace_back();
      if (picture == fingerprint.pictures.end()) continue;
      matches.cases.back() = match_of(levels_of(picture->second, i), deviations[i], limits_[i]);
    }
    return matches;
  }

  std::vector<std::uint8_t> levels_of(const StoredPicture& picture, std::size_t i) const {
    return picture.levels(limits_[i].width(), limits_[i].height());
  }

  std::vector<Entry> ordered_entries(std::span<const Suspicion> findings) const {
    std::vector<Entry> entries;
    std::vector<Likeness> singles;
    for (std::size_t i = 0; i < mistakes_.size(); ++i) {
      singles.push_back(likeness(deviations_, mistakes_[i]));
      entries.push_back({{i}, nullptr, singles.back()});
      if (!fingerprints_[i].parts.empty()) singles.back() = {};  // a named pair is not paired again
    }
    for (const LikelyPair& pair : likely_pairs(deviations_, mistakes_, singles, kMostPairs))
      entries.push_back({{pair.mistakes[0], pair.mistakes[1]}, nullptr, pair.likeness});
    for (const Suspicion& finding : findings)
      entries.push_back({{}, &finding, {finding.likeness, finding.explained, finding.missed, {}}});
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
    std::vector<Deviation> deviations;
    const Fingerprint& first = fingerprints_[a.mistakes[0]];
    for (std::size_t i = 0; i < cases_.size(); ++i) {
      const auto picture = first.pictures.find(cases_[i].id);
      deviations.push_back(picture == first.pictures.end() ? deviation_of(limits_[i].nominal(), limits_[i])
                                                           : deviation_of(levels_of(picture->second, i), limits_[i]));
    }
    return likeness(deviations, matches_of(fingerprints_[b.mistakes[0]], deviations)).value >= kSameLikeness;
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
    suspicion.pixels = pixels_of(entry);
    return suspicion;
  }

  /// Where the entry agrees with the submission, a pixel of each of the cases in which it does so most.
  std::vector<DiagnosisPixel> pixels_of(const Entry& entry) const {
    struct Place {
      std::int64_t agreed;
      std::size_t mistake, picture;
    };
    std::vector<Place> places;
    for (std::size_t i = 0; i < cases_.size(); ++i) {
      Place best{0, 0, i};
      for (const std::size_t m : entry.mistakes)
        if (const auto& match = mistakes_[m].cases[i]; match && match->agrees.count() > best.agreed)
          best = {match->agrees.count(), m, i};
      if (best.agreed > 0) places.push_back(best);
    }
    std::ranges::stable_sort(places, std::ranges::greater{}, &Place::agreed);
    std::vector<DiagnosisPixel> pixels;
    for (const std::size_t m : shown_first(entry, places)) {
      const Place& place = places[m];
      const std::size_t i = place.picture;
      const StoredPicture& picture = fingerprints_[place.mistake].pictures.at(cases_[i].id);
      if (const auto pixel = evidence_pixel(cases_[i], limits_[i], deviations_[i], levels_of(picture, i)))
        pixels.push_back(*pixel);
    }
    return pixels;
  }

  /// Numbers of the places to show: of two mistakes the best of each, then the rest in order.
  template <class Places>
  std::vector<std::size_t> shown_first(const Entry& entry, const Places& places) const {
    std::vector<std::size_t> order;
    const auto add = [&](std::size_t i) {
      if (order.size() < kMostPixels && std::ranges::find(order, i) == order.end()) order.push_back(i);
    };
    for (const std::size_t m : entry.mistakes)
      for (std::size_t i = 0; i < places.size(); ++i)
        if (places[i].mistake == m) {
          add(i);
          break;
        }
    for (std::size_t i = 0; i < places.size(); ++i) add(i);
    return order;
  }

  std::span<const Fingerprint> fingerprints_;
  std::vector<DiagnosisCase> cases_;
  std::vector<EvidenceLimits> limits_;
  std::vector<Deviation> deviations_;
  std::vector<MistakeMatches> mistakes_;
  bool shows_something_ = false;
};

}  // namespace

Diagnosis diagnose(std::span<const DiagnosisCase> cases, std::span<const Fingerprint> fingerprints,
                   std::span<const Suspicion> findings) {
  return Diagnostician(cases, fingerprints).diagnose(findings);
}

}  // namespace plumb

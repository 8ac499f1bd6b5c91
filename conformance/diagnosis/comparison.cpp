#include "conformance/diagnosis/comparison.h"

#include <algorithm>
#include <stdexcept>

namespace plumb {
namespace {

/// A picture says something from this share of wrong pixels on (docs/diagnosis.md).
constexpr double kLeastWrongShare = 0.001;

}  // namespace

Comparison::Comparison(std::span<const DiagnosisCase> cases) {
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

std::vector<std::uint8_t> Comparison::levels(const Fingerprint& mistake, std::size_t i,
                                             const PictureChange* change) const {
  const int width = limits_[i].width(), height = limits_[i].height();
  const auto picture = mistake.pictures.find(cases_[i].id);
  const std::span<const std::uint8_t> right = limits_[i].nominal();
  std::vector<std::uint8_t> drawn = picture == mistake.pictures.end()
                                        ? std::vector<std::uint8_t>(right.begin(), right.end())
                                        : picture->second.levels(width, height);
  return change ? change->apply(drawn, width, height) : drawn;
}

std::vector<MistakeMatches> Comparison::matches(const Fingerprint& mistake,
                                                std::span<const PictureChange> changes) const {
  std::vector<MistakeMatches> matches(1 + changes.size(), {{}, {}, mistake.in_places});
  for (std::size_t i = 0; i < cases_.size(); ++i) {
    const bool unknown = std::ranges::find(mistake.no_picture, cases_[i].id) != mistake.no_picture.end();
    for (MistakeMatches& m : matches) m.unknown.push_back(unknown), m.cases.emplace_back();
    const bool shows = mistake.pictures.contains(cases_[i].id);
    if (!shows && changes.empty()) continue;
    const std::vector<std::uint8_t> drawn = levels(mistake, i, nullptr);
    if (shows) matches[0].cases[i] = match_of(drawn, deviations_[i], limits_[i]);
    for (std::size_t k = 0; k < changes.size(); ++k)
      matches[1 + k].cases[i] =
          match_of(changes[k].apply(drawn, limits_[i].width(), limits_[i].height()), deviations_[i], limits_[i]);
  }
  return matches;
}

double Comparison::likeness_of(const Fingerprint& a, const Fingerprint& b) const {
  std::vector<Deviation> deviations;
  MistakeMatches matches;
  for (std::size_t i = 0; i < cases_.size(); ++i) {
    deviations.push_back(deviation_of(levels(a, i, nullptr), limits_[i]));
    matches.unknown.push_back(std::ranges::find(b.no_picture, cases_[i].id) != b.no_picture.end());
    matches.cases.push_back(match_of(levels(b, i, nullptr), deviations[i], limits_[i]));
  }
  return likeness(deviations, matches).value;
}

}  // namespace plumb

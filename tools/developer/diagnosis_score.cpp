#include "tools/developer/diagnosis_score.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <set>
#include <sstream>

#include "conformance/diagnosis/deviation.h"
#include "conformance/judge/suite.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

using Pictures = std::map<std::string, std::vector<std::uint8_t>>;

double cpu_now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Pictures decoded(const PlantedPictures& program, const DiagnosisKnowledge& knowledge) {
  Pictures pictures;
  for (const auto& [id, file] : program.pictures) {
    const auto envelope = knowledge.envelopes.find(id);
    if (envelope == knowledge.envelopes.end()) continue;
    try {
      pictures[id] = StoredPicture(file).levels(envelope->second.width, envelope->second.height);
    } catch (const InputError&) {
      // Of another size: nothing to compare.
    }
  }
  return pictures;
}

std::vector<DiagnosisCase> cases_of(const Pictures& pictures, const DiagnosisKnowledge& knowledge, int tolerance) {
  std::vector<DiagnosisCase> cases;
  for (const auto& [id, levels] : pictures) cases.push_back({id, &knowledge.envelopes.at(id), tolerance, levels});
  return cases;
}

/// Whether more than so small a share of some case is evidence against it that a right program may do it, too.
bool leaves_envelopes(const Pictures& pictures, const DiagnosisKnowledge& knowledge, int tolerance) {
  return std::ranges::any_of(pictures, [&](const auto& picture) {
    const EvidenceLimits limits(knowledge.envelopes.at(picture.first), tolerance);
    return static_cast<double>(deviation_of(picture.second, limits).wrong.count()) >
           0.002 * static_cast<double>(limits.pixels());
  });
}

/// Whether in some case more than a half percent of the pixels are more than a few levels apart.
bool differ(const Pictures& a, const Pictures& b) {
  return std::ranges::any_of(a, [&](const auto& picture) {
    const auto other = b.find(picture.first);
    if (other == b.end()) return true;
    const std::vector<std::uint8_t>&x = picture.second, &y = other->second;
    std::size_t apart = 0;
    for (std::size_t i = 0; i < x.size(); i += 3)
      apart += std::abs(x[i] - y[i]) > 4 || std::abs(x[i + 1] - y[i + 1]) > 4 || std::abs(x[i + 2] - y[i + 2]) > 4;
    return static_cast<double>(apart) > 0.005 * static_cast<double>(x.size() / 3);
  });
}

/// What a suspicion names: its mistake or both, and with a single one those that cannot be told from it.
std::vector<std::set<std::string>> names_of(const Suspicion& suspicion) {
  std::vector<std::set<std::string>> names;
  if (!suspicion.parts.empty()) {
    for (const std::string& part : suspicion.parts) names.push_back({part});
    return names;
  }
  names.push_back({suspicion.id});
  names.back().insert(suspicion.or_one_of.begin(), suspicion.or_one_of.end());
  return names;
}

bool meets(const std::set<std::string>& names, const std::vector<std::string>& right) {
  return std::ranges::any_of(right, [&](const std::string& id) { return names.contains(id); });
}

/// Whether all that is named is right, and all that is planted is named.
bool is_right(const Suspicion& suspicion, const std::vector<std::vector<std::string>>& planted) {
  const auto names = names_of(suspicion);
  return std::ranges::all_of(
             names,
             [&](const auto& n) { return std::ranges::any_of(planted, [&](const auto& p) { return meets(n, p); }); }) &&
         std::ranges::all_of(planted, [&](const auto& p) {
           return std::ranges::any_of(names, [&](const auto& n) { return meets(n, p); });
         });
}

bool names_only_planted(const Suspicion& suspicion, const std::vector<std::vector<std::string>>& planted) {
  return std::ranges::all_of(names_of(suspicion), [&](const auto& n) {
    return std::ranges::any_of(planted, [&](const auto& p) { return meets(n, p); });
  });
}

void add(const DiagnosisOutcome& outcome, const PlantedPictures& program, DiagnosisScore& score) {
  const std::vector<Suspicion>& list = outcome.diagnosis.suspicions;
  const bool confident = outcome.diagnosis.confident;
  score.most_cpu_seconds = std::max(score.most_cpu_seconds, outcome.cpu_seconds);
  if (program.mistakes.empty()) {
    score.false_alarms.count(!list.empty());
    return;
  }
  if (!outcome.shows) return;
  const bool honest = !confident || (!list.empty() && names_only_planted(list[0], program.mistakes));
  score.confidently_wrong.count(!honest);
  if (outcome.unnamed > 0) {
    score.unknown_kept_open.count(honest);
  } else if (program.mistakes.size() == 1) {
    score.first.count(outcome.first_right);
    score.three.count(outcome.three_right);
    score.confident.count(confident);
  } else {
    score.both_named.count(outcome.first_right);
    score.one_named.count(!outcome.first_right && !list.empty() && names_only_planted(list[0], program.mistakes));
  }
}

/// An end of the interval; `side` is -1 or 1.
double wilson(std::int64_t hits, std::int64_t tries, int side) {
  if (tries == 0) return side < 0 ? 0 : 1;
  constexpr double z = 1.959963984540054;  // of a normal distribution, 19 in 20 lie within
  const double n = static_cast<double>(tries), p = static_cast<double>(hits) / n;
  return (p + z * z / (2 * n) + side * z * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n))) / (1 + z * z / n);
}

}  // namespace

double Rate::low() const { return std::max(0.0, wilson(hits, tries, -1)); }  // rounding may leave less
double Rate::high() const { return wilson(hits, tries, 1); }

DiagnosisKnowledge read_knowledge(const fs::path& built) {
  const Suite suite = read_suite(built / "suite.toml");
  if (suite.fingerprints.empty())
    throw InputError({suite.file.string()}, "has no fingerprints, expected a suite that was built with them");
  DiagnosisKnowledge knowledge;
  for (const SuiteCase& c : suite.cases)
    if (!c.envelopes.empty()) knowledge.envelopes[c.id] = read_envelope(c.envelopes.front());
  knowledge.fingerprints = read_fingerprints(suite.fingerprints);
  return knowledge;
}

std::vector<PlantedPictures> read_planted_pictures(const fs::path& folder) {
  std::vector<PlantedPictures> programs;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (!entry.is_directory()) continue;
    PlantedPictures program{entry.path().filename(), {}, {}};
    std::ifstream expected(entry.path() / "expected");
    if (!expected) throw InputError({(entry.path() / "expected").string()}, "cannot be opened");
    for (std::string line; std::getline(expected, line);) {
      std::istringstream words(line);
      program.mistakes.emplace_back();
      for (std::string word; words >> word;) program.mistakes.back().push_back(word);
    }
    for (const auto& file : fs::directory_iterator(entry.path()))
      if (file.path().extension() == ".png") program.pictures[file.path().stem()] = file.path();
    if (!program.pictures.empty()) programs.push_back(std::move(program));
  }
  std::ranges::sort(programs, {}, &PlantedPictures::label);
  return programs;
}

DiagnosisScore score_diagnosis(const DiagnosisKnowledge& knowledge, const std::vector<PlantedPictures>& programs,
                               int tolerance) {
  DiagnosisScore score;
  for (const PlantedPictures& program : programs) {
    DiagnosisOutcome outcome{program.label, 0, 0, false, false, false, {}, 0};
    for (const auto& names : program.mistakes) ++(names.empty() ? outcome.unnamed : outcome.named);
    const double begin = cpu_now();
    const Pictures pictures = decoded(program, knowledge);
    outcome.diagnosis = diagnose(cases_of(pictures, knowledge, tolerance), knowledge.fingerprints);
    outcome.cpu_seconds = cpu_now() - begin;
    outcome.shows = leaves_envelopes(pictures, knowledge, tolerance);
    if (const std::size_t plus = program.label.find('+'); plus != std::string::npos)
      for (const std::string& part : {program.label.substr(0, plus), program.label.substr(plus + 1)}) {
        const auto alone = std::ranges::find(programs, part, &PlantedPictures::label);
        if (alone != programs.end() && !differ(pictures, decoded(*alone, knowledge))) outcome.shows = false;
      }
    const std::vector<Suspicion>& list = outcome.diagnosis.suspicions;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, list.size()); ++i)
      if (is_right(list[i], program.mistakes)) outcome.three_right = true, outcome.first_right |= i == 0;
    add(outcome, program, score);
    score.outcomes.push_back(std::move(outcome));
  }
  return score;
}

}  // namespace plumb

#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "conformance/diagnosis/diagnose.h"

namespace plumb {

/// What a built suite knows: envelopes by case id, and the fingerprints of known mistakes.
struct DiagnosisKnowledge {
  std::map<std::string, Envelope> envelopes;
  std::vector<Fingerprint> fingerprints;
};

/// Of a built suite, with the envelopes of its first variant. Throws InputError as read_suite and read_envelope, and
/// for a suite without fingerprints.
DiagnosisKnowledge read_knowledge(const std::filesystem::path& built);

/// The pictures of one program with planted mistakes.
struct PlantedPictures {
  std::string label;
  /// For each planted mistake the ids that are the right name for it, none if no known mistake is. Empty: a right
  /// program.
  std::vector<std::vector<std::string>> mistakes;
  std::map<std::string, std::filesystem::path> pictures;
};

/// Every folder `LABEL/` with its `expected` (a line for each planted mistake, with the ids that are right) and
/// `CASE.png`, in order of label. A folder without pictures is left out.
std::vector<PlantedPictures> read_planted_pictures(const std::filesystem::path& folder);

/// What came of one program.
struct DiagnosisOutcome {
  std::string label;
  /// Planted mistakes that have a name; those without.
  std::size_t named = 0, unnamed = 0;
  /// Whether some picture is outside of its envelope; of a pair, whether it also differs from those of either alone.
  bool shows = false;
  bool first_right = false, three_right = false;
  Diagnosis diagnosis;
  double cpu_seconds = 0;
};

/// A share of so many tries, with the interval in which it lies by a method that is wrong once in twenty times [Wilson
/// 1927].
struct Rate {
  std::int64_t hits = 0, tries = 0;
  void count(bool hit) { ++tries, hits += hit; }
  double low() const;
  double high() const;
};

struct DiagnosisScore {
  std::vector<DiagnosisOutcome> outcomes;
  /// Of single mistakes that have a name and show. A suspicion is right if all that it names is right; `three`: one of
  /// the first three is.
  Rate first, three, confident;
  /// Of everything that shows and is wrong by more than a right program: confident, and not right.
  Rate confidently_wrong;
  /// Of pairs that show: the first suspicion names both; it names one of them and nothing else.
  Rate both_named, one_named;
  /// Of right programs: those with any suspicion.
  Rate false_alarms;
  /// Of mistakes that no known one equals: those for which nothing was confident.
  Rate unknown_kept_open;
  double most_cpu_seconds = 0;
};

/// Diagnoses each program. `tolerance`: of the cases. Of a pair `A+B` the programs `A` and `B`, where they are in the
/// list, tell whether both mistakes show.
DiagnosisScore score_diagnosis(const DiagnosisKnowledge& knowledge, const std::vector<PlantedPictures>& programs,
                               int tolerance = 1);

}  // namespace plumb

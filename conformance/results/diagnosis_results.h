#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace plumb {

/// A pixel at which a mistake shows, rows from the top.
struct DiagnosisPixel {
  std::string case_id;
  int x = 0, y = 0;
  /// Levels: of the reference, of the submission, and of a program with the mistake.
  std::array<std::uint8_t, 3> expected{}, found{}, suspected{};
};

/// A mistake that may be in a program, and how far it accounts for its wrong pictures.
struct Suspicion {
  std::string id, name, hint;
  /// The ids of two mistakes that are suspected together; empty for a single one.
  std::vector<std::string> parts;
  /// Ids of other mistakes whose pictures cannot be told from this one's in these cases.
  std::vector<std::string> or_one_of;
  /// The share of the submission's wrong area, over all cases at once, that the mistake reproduces.
  double explained = 0;
  /// The share of the area where the mistake shows in which the submission is right.
  double missed = 0;
  /// What the list is ordered by, in [0, 1]: how alike the two patterns of wrong pixels are (docs/diagnosis.md).
  double likeness = 0;
  /// From at most three cases, the one that tells most first.
  std::vector<DiagnosisPixel> pixels;
};

struct Diagnosis {
  /// The likeliest first. Empty: no known mistake accounts for the pictures ("unknown"), or none is wrong.
  std::vector<Suspicion> suspicions;
  /// Whether the first accounts for nearly everything and clearly better than any that differs from it.
  bool confident = false;
};

}  // namespace plumb

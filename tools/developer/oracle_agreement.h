#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "conformance/families/family.h"

namespace plumb {

/// What two independent ways to the exact answer had to say about one family.
struct OracleAgreement {
  std::string family{};
  /// What was compared: rays, boxes, matrices or reflectances.
  std::int64_t cases = 0;
  std::int64_t disagreements = 0;
  /// Of the filtered way: cases that doubles could not decide.
  std::int64_t undecided = 0;
  /// The first disagreement, to be asked again; empty if there is none.
  std::string first{};
};

/// Rays of a family, half in float and half in double precision, by polynomials, by rationals and filtered: every field
/// of the three answers is the same (`count` rays at least).
OracleAgreement agree_on_rays(const FamilyKind& family, std::int64_t count);
/// Boxes of the surfaces of a family, tight and off by a double, by polynomials and by rationals.
OracleAgreement agree_on_boxes(const FamilyKind& family, std::int64_t count);
/// M4: matrices of rotations, their inverses, cosines and sines, by degrees and by radians and quaternions, at
/// different precisions.
OracleAgreement agree_on_rotations(std::int64_t count);
/// F1: reflectances by cosines and by angles, at different precisions.
OracleAgreement agree_on_fresnel(std::int64_t count);

}  // namespace plumb

#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "conformance/families/family.h"
#include "conformance/subject/subject.h"
#include "conformance/verdict.h"
#include "reference/exact_hit.h"

namespace plumb {

/// Degrees. Rounding moves a normal by far less; the usual mistake, M in place of its inverse transpose, by tens of
/// degrees.
constexpr double kNormalAngle = 0.01;

/// What was found of a family's rays, each at one surface alone.
struct ClassCounts {
  std::int64_t cases = 0;
  std::int64_t rays = 0;
  /// Of the truth.
  std::int64_t hits = 0, free = 0;
  std::int64_t false_misses = 0, false_hits = 0, wrong_crossings = 0;
  /// Of the wrong ones, those that rounding does not excuse (within_rounding).
  std::int64_t outside_band = 0;
  /// Rays from inside of a solid that hit nothing.
  std::int64_t escapes = 0;
  /// Where asked for: hits that must be reported, but that rounding may lose (within_rounding), and those that were
  /// lost.
  std::int64_t near_hits = 0, near_misses = 0;
  /// Where asked for: hits whose t is that of another place (is_another_place).
  std::int64_t other_places = 0;
  /// Left out because their coordinates pass the contract's largest.
  std::int64_t too_large = 0;
  /// Hits where there is one to report; those whose t is a distance (is_distance).
  std::int64_t hits_told = 0, distances = 0;
  /// Normals that were reported with right hits; those off by more than kNormalAngle; those on the wrong side.
  std::int64_t normals = 0, normals_off = 0, normals_flipped = 0;
  double largest_normal_angle = 0;
  /// The error of t of each right hit, in ulps over the case's condition; sorted.
  std::vector<double> t_errors;

  /// The worst case: a wrong class outside of the band or a t of another place, else an escape, else any wrong one,
  /// else the largest error of t.
  struct Worst {
    int rank = 0;
    double t_error = -1;
    double margin_u = 0;
    std::string truth, answer, command;
  } worst;

  std::int64_t wrong() const { return false_misses + false_hits + wrong_crossings; }
  /// The error of t that a share of the hits does not pass; 0 without hits.
  double t_percentile(double share) const;
};

/// What is counted besides, of families that need it: the hits that rounding may lose, and hits at another place.
struct CountedToo {
  bool near_hits = false;
  bool other_places = false;
};

/// Asks `count` rays of the family (whole cases, so a few more), and judges each answer against the exact truth by the
/// subject's contract. The truth is taken on the matrices that the subject reports, where it reports any. Throws
/// UnsupportedBySubject if the contract lacks what the family needs.
ClassCounts ask_family(
    Subject& subject, const FamilyKind& family, std::uint64_t seed, std::int64_t count,
    const std::function<void(double)>& progress = [](double) {}, CountedToo too = {});

/// Whether the contract names the surface's shape, and transforms where it has one.
bool can_build(const Contract& contract, const SubjectSurface& surface);

/// The precision in which a family is made for a subject: float too where its meshes pass through files of floats.
plumb_precision family_precision(const Contract& contract, ShapeKind kind);

/// Counts and rates as evidence, with the worst case as hex floats and the command that explains it.
void add_evidence(const ClassCounts& counts, Evidence& evidence);

}  // namespace plumb

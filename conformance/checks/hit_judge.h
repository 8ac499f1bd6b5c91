#pragma once

#include <optional>

#include "conformance/subject/subject.h"
#include "reference/exact_hit.h"

namespace plumb {

/// What is wrong with the answer to one ray.
enum class AnswerFault {
  none,
  false_miss,      ///< there is a crossing that must be reported, and none was
  false_hit,       ///< nothing lies in the range, and a hit was reported
  wrong_crossing,  ///< a hit, but nearest to a crossing behind one that must be reported
};

/// An answer held against the truth under a contract.
struct AnswerJudgement {
  AnswerFault fault = AnswerFault::none;
  /// For a hit that is right: which of the truth's crossings it means, and by how many ulps (of the contract's
  /// precision of t) t is off, 0 meaning correctly rounded.
  std::optional<std::size_t> crossing;
  double t_ulps = 0;
  /// Either answer was right: every crossing is a tangent or on a boundary, or there is one before the first proper
  /// crossing.
  bool free = false;
  /// The origin lies inside of a solid, or the answer must be a hit for another reason, and the ray is endless: a miss
  /// is an escape.
  bool must_hit = false;
  /// The contract asks for a hit, and the origin is not inside of a solid, which no rounding of a boundary could
  /// excuse.
  bool must_report = false;
};

/// The crossings that count by the contract: without back faces where those are culled, without the ends of an open
/// range, and none for a ray from inside of a solid where the contract says that it misses.
std::vector<ExactCrossing> crossings_by_contract(const ExactHit& truth, const Ray& ray, ShapeKind kind,
                                                 const Contract& contract);

/// A closed solid or a triangle, alone: a free crossing may be reported or not, the first proper one must be, unless a
/// free one before it is. An answer means the crossing nearest to it in t.
AnswerJudgement judge_answer(const ExactHit& truth, const Ray& ray, ShapeKind kind, const Contract& contract,
                             const SubjectHit& answer);

/// |t - exact| in units of the last place of the exact value rounded to the precision, which `crossing` holds.
double t_error_ulps(double t, const ExactCrossing& crossing, plumb_precision precision);

/// Whether t is not the exact one, but that times the direction's length, in world or in object space: the mistake of
/// who makes a direction unit and forgets that t counts in its lengths. To 2^20 u.
bool is_distance(double t, const ExactCrossing& crossing, const PlacedShape& shape, const Ray& ray,
                 const Contract& contract);

/// Whether t is off by more than 2^20 u of what its formulas add up: |t| and the largest distance from the origin to
/// the shape over the direction's length. That is no rounding of any formula unless the ray grazes the surface at an
/// angle of some 2^-20, but another place; unlike a number of ulps it means something where the exact t is about zero.
bool is_another_place(double t, const ExactCrossing& crossing, const PlacedShape& shape, const Ray& ray,
                      const Contract& contract);

/// The unit roundoff: 2^-24 or 2^-53.
double unit_roundoff(plumb_precision precision);

/// Whether an answer that is wrong for this ray is right for one that rounding cannot tell from it: a triangle's edge
/// passed within 16 u |d| |s| |e| (edge_margin), or a ray whose origin is moved along an axis by 16 u times the largest
/// distance from the origin to the shape, whose direction by 16 u of its length, or whose range by 16 u of its ends and
/// as much as the origin, all times `condition`. A solid may also be larger or smaller by as much as the origin is
/// moved (in object space), as what has no thickness is missed by every ray that is moved. The factor 16 covers the
/// longest chain of operations of the usual formulas (Moller-Trumbore: 8 roundings a term, [Shewchuk 1997]). For a
/// triangle in world space the condition does not count: it is that of t, a quotient, while the class is one of signs
/// of determinants, whose rounding knows nothing of it.
bool within_rounding(const PlacedShape& shape, const Ray& ray, const Contract& contract, double condition,
                     const SubjectHit& answer);

}  // namespace plumb

#pragma once

#include <string_view>

#include "conformance/checks/check.h"
#include "conformance/checks/class_question.h"

namespace plumb {

/// Rays that a family is asked at intensity 1, of a kernel; a probe is asked Subject::pace() of it.
constexpr std::int64_t kFamilyRays = 100'000;

/// What is asked of normals, where the subject reports them.
enum class NormalRule { told, line, side };

/// Whether the error of t of a family decides, or is only told and decides where it is that of another place
/// (is_another_place).
enum class TimeRule { judged, told };

/// Whether a subject must report some of the hits that rounding may lose.
enum class BoundaryRule { free, judged };

/// The check of a family of rays at single surfaces. Fails for
/// - `escape`: a ray from inside of a solid that hits nothing;
/// - `class`: more than one answer per million that is wrong and not excused by rounding (within_rounding);
/// - `boundary`, where it is judged: of 64 hits or more that rounding may lose, more than three quarters are missed.
///   Rounding moves a boundary in as often as out; of 64 fair coins more than 48 fall on one side once in 30,000 runs;
/// - `normal`: more than one normal per thousand (hits beside an edge of a solid have two right ones) that is off by
/// more than
///   kNormalAngle, or, by NormalRule::side, points to the other side;
/// - `t`, where it is judged: median above 4 ulps, or the 99th percentile above 64, over the case's condition; where it
///   is told, more than one hit per million at another place;
/// - `t_normalised`, in place of any of these: most hits' t are distances (is_distance).
/// Whether every answer is right to the last bit (`gold`) and the rates of those that rounding excuses are evidence, no
/// verdict.
CheckResult check_family(std::string_view id, Subject& subject, const CheckOptions& options,
                         TimeRule time = TimeRule::judged, NormalRule normals = NormalRule::told,
                         BoundaryRule boundary = BoundaryRule::free);

/// The verdict on counts that were made before.
CheckResult judge_counts(const ClassCounts& counts, const Contract& contract, TimeRule time,
                         NormalRule normals = NormalRule::told);

/// Sentences that checks of families share.
inline constexpr std::string_view kClassTolerance =
    "A wrong class counts unless rounding in the subject's own precision excuses it: the ray passes the edge within 16 "
    "u "
    "|d||s||e|, or moving it by 16 u makes the answer right; of the others at most one in a million. t: median 4 ulps, "
    "99th "
    "percentile 64, divided by the case's condition. A ray that leaves a solid from inside must hit.";

/// Those of families that aim at boundaries, where every answer by itself is excused.
inline constexpr std::string_view kBoundaryTolerance =
    "As for the other families of single surfaces. And as rounding moves a boundary in as often as out, of the hits "
    "that it may lose (64 or more) at most three quarters may be missed: of 64 fair coins more than 48 fall on one "
    "side once in 30,000 runs.";

}  // namespace plumb

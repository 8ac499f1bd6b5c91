#include "conformance/checks/class_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

constexpr double kMedianUlps = 4;
constexpr double kHighUlps = 64;
constexpr double kPerMillion = 1e-6;
constexpr double kPerThousand = 1e-3;
constexpr std::int64_t kFewestNearHits = 64;
constexpr double kNearMisses = 0.75;
/// Of the hits: more is no coincidence, less may be where another mistake is made too.
constexpr double kDistances = 0.5;

std::string class_sentence(const ClassCounts& c) {
  if (c.wrong() == 0)
    return fmt::format("{} rays, 0 wrong (< {:.3g} per million at 95 %)", c.rays, 3e6 / static_cast<double>(c.rays));
  return fmt::format("{} rays: {} false misses, {} false hits, {} wrong crossings; {} not excused by rounding", c.rays,
                     c.false_misses, c.false_hits, c.wrong_crossings, c.outside_band);
}

}  // namespace

CheckResult judge_counts(const ClassCounts& counts, const Contract& contract, TimeRule time, NormalRule normals) {
  CheckResult result;
  result.verdict = Verdict::pass;
  result.evidence.emplace_back("contract", to_string(contract));
  result.evidence.emplace_back("gold", std::string(counts.wrong() == 0 ? "yes" : "no"));
  add_evidence(counts, result.evidence);
  const double allowed = std::floor(static_cast<double>(counts.rays) * kPerMillion);
  const double median = counts.t_percentile(0.5);
  const double high = counts.t_percentile(0.99);
  result.summary =
      fmt::format("{}; t off by {:.2g} ulps in the median, {:.2g} at 99 %", class_sentence(counts), median, high);

  const auto fail = [&](const char* cause, double margin, const std::string& advice) {
    result.verdict = Verdict::fail;
    result.cause = cause;
    result.margin = margin;
    result.advice = advice;
  };
  const auto outside = static_cast<double>(counts.outside_band);
  const auto near_hits = static_cast<double>(counts.near_hits);
  const auto near_misses = static_cast<double>(counts.near_misses);
  if (counts.escapes > 0) {
    fail("escape", -static_cast<double>(counts.escapes),
         "rays from inside of a solid leave it unseen: intersect the side's interval with the slab's instead of "
         "testing side and caps apart");
  } else if (outside > allowed) {
    fail("class", allowed - outside, "see the worst case, and what the oracle says of it: " + counts.worst.command);
  } else if (counts.near_hits >= kFewestNearHits && near_misses > kNearMisses * near_hits) {
    fail("boundary", kNearMisses - near_misses / near_hits,
         fmt::format("{} of {} hits at the boundary are missed, where rounding would lose half at most: something is "
                     "cut off by an epsilon or a strict comparison; one of them: {}",
                     counts.near_misses, counts.near_hits, counts.worst.command));
  } else if (time == TimeRule::told && static_cast<double>(counts.other_places) > allowed) {
    fail("t", allowed - static_cast<double>(counts.other_places),
         "hits lie at another place than the surface; one of them: " + counts.worst.command);
  } else if (normals != NormalRule::told &&
             static_cast<double>(counts.normals_off) > kPerThousand * static_cast<double>(counts.normals)) {
    fail("normal", kNormalAngle - counts.largest_normal_angle,
         "normals are not perpendicular to the surface: they are carried by the inverse transpose of the matrix, not "
         "by the matrix");
  } else if (normals == NormalRule::side &&
             static_cast<double>(counts.normals_flipped) > kPerThousand * static_cast<double>(counts.normals)) {
    fail("normal", -static_cast<double>(counts.normals_flipped),
         "normals point inwards under a mirroring transform: its determinant is negative");
  } else if (time == TimeRule::judged && (median > kMedianUlps || high > kHighUlps)) {
    fail("t", std::min(kMedianUlps - median, kHighUlps - high),
         "t is less accurate than the precision allows; the worst case: " + counts.worst.command);
  } else {
    result.margin = allowed - outside;
  }
  if (result.verdict == Verdict::fail &&
      static_cast<double>(counts.distances) > kDistances * static_cast<double>(counts.hits_told)) {
    result.cause = "t_normalised";
    result.advice =
        "t is the distance, not the number of the direction's lengths: the direction was made unit, here or "
        "in the surface's own space, where it changes t; one case: " +
        counts.worst.command;
  }
  return result;
}

CheckResult check_family(std::string_view id, Subject& subject, const CheckOptions& options, TimeRule time,
                         NormalRule normals, BoundaryRule boundary) {
  const auto count =
      static_cast<std::int64_t>(std::ceil(static_cast<double>(kFamilyRays) * options.intensity * subject.pace()));
  const ClassCounts counts =
      ask_family(subject, family_kind(id), options.seed, count, options.progress,
                 {.near_hits = boundary == BoundaryRule::judged, .other_places = time == TimeRule::told});
  return judge_counts(counts, subject.contract(), time, normals);
}

}  // namespace plumb

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "conformance/checks/check.h"
#include "conformance/checks/describe.h"
#include "conformance/checks/hit_judge.h"
#include "conformance/families/random.h"
#include "reference/exact_optics.h"

namespace plumb {
namespace {

constexpr double kQueries = 20'000;
/// Where sin^2 is this near to critical, the reflectance goes with the square root of the distance.
constexpr double kNearCritical = 1e-4;
constexpr double kNearTolerance = 1e-6;
/// The amplitudes (a - b) / (a + b) are off by a few u, so the reflectance, their mean square, by a few u (R + sqrt R);
/// but they hold the refracted cosine c, the root of 1 - sin^2, whose few u of error are as many u / c^2 of c.
constexpr double kUnits = 64;
constexpr double kFreeUnits = 4;

struct Query {
  double cosine, from, to;
};

/// Ordinary angles; the critical angle +- 1e-16 .. 1e-4; grazing; indices that hardly differ; each a quarter.
Query make_query(Random& random, std::int64_t i) {
  const double from = 1 + random.unit();
  const double to = 1 + random.unit();
  const double tiny = std::ldexp(1 + random.unit(), -static_cast<int>(14 + random.below(40)));
  switch (i % 4) {
    case 0:
      return {random.unit(), from, to};
    case 1: {
      const double dense = std::max(from, to), thin = std::min(from, to);
      const double critical = std::sqrt(std::max(0.0, (1 - thin / dense) * (1 + thin / dense)));
      return {std::clamp(critical + (random.below(2) ? tiny : -tiny), 0.0, 1.0), dense, thin};
    }
    case 2:
      return {tiny, from, to};
    default:
      return {random.unit(), from, from * (1 + (random.below(2) ? tiny : -tiny))};
  }
}

struct Counts {
  std::int64_t queries = 0, free = 0, wrong_decisions = 0, wrong_values = 0;
  double largest = 0;
  std::string worst;
};

void judge(const Query& q, double claimed, double u, Counts& counts) {
  const ExactFresnel exact = exact_fresnel(q.cosine, q.from, q.to);
  ++counts.queries;
  const double truth = exact.reflectance.below;
  const double off = std::fabs(claimed - truth);
  const bool near = exact.distance_to_critical < kNearCritical;
  // Within 4 u of critical, total or not, is a matter of rounding, and both are near 1 there.
  const bool free = exact.distance_to_critical <= kFreeUnits * u;
  counts.free += free;
  const double c = exact.refracted_cosine.below;
  const double condition = exact.total_internal_reflection ? 1 : 1 + 1 / (c * c);
  const double rounding = kUnits * u * condition * (truth + std::sqrt(truth) + u);
  const double allowed = near ? std::max(kNearTolerance, std::sqrt(u) * 16) : rounding;
  // NaN is wrong too, and wrong by more than any number.
  const double share = std::isnan(off) ? Bounds3::kInfinity : off / allowed;
  const bool wrong = !(share <= 1);
  counts.wrong_values += wrong;
  counts.wrong_decisions += wrong && !free && (claimed == 1) != exact.total_internal_reflection;
  if (share > counts.largest || counts.worst.empty()) {
    counts.largest = share;
    counts.worst = fmt::format("cosine {} from {} to {}: {} ({:.17g}), exactly {:.17g}", hex(q.cosine), hex(q.from),
                               hex(q.to), hex(claimed), claimed, truth);
  }
}

CheckResult run(Subject& subject, const CheckOptions& options) {
  if (!subject.contract().fresnel) throw UnsupportedBySubject(subject.name() + " does not answer Fresnel reflectance");
  const double u = unit_roundoff(subject.contract().precision);
  const auto count = static_cast<std::int64_t>(std::ceil(kQueries * options.intensity));
  Random random(options.seed, "F1", 0);
  std::vector<Query> queries;
  for (std::int64_t i = 0; i < count; ++i) queries.push_back(make_query(random, i));
  Counts counts;
  for (const Query& q : queries) {
    judge(q, subject.fresnel(q.cosine, q.from, q.to), u, counts);
    options.progress(static_cast<double>(counts.queries) / static_cast<double>(count));
  }
  CheckResult result;
  result.verdict = counts.wrong_values == 0 ? Verdict::pass : Verdict::fail;
  result.cause = counts.wrong_decisions > 0 ? "total_reflection" : counts.wrong_values > 0 ? "reflectance" : "";
  result.margin = 1 - counts.largest;
  result.evidence = {{"queries", counts.queries},
                     {"free", counts.free},
                     {"wrong_decisions", counts.wrong_decisions},
                     {"wrong_values", counts.wrong_values},
                     {"largest_error_over_allowed", counts.largest},
                     {"worst", counts.worst}};
  result.summary = fmt::format("{} reflectances, {} wrong; the worst error is {:.2g} of what is allowed",
                               counts.queries, counts.wrong_values, counts.largest);
  if (counts.wrong_values > 0) result.advice = "the worst case: " + counts.worst;
  return result;
}

}  // namespace

extern const CheckKind f01_fresnel_check_kind{
    .id = "F1",
    .title = "Fresnel reflectance and total internal reflection",
    .asks =
        "The unpolarised reflectance for ordinary angles, about the critical angle, at grazing incidence, and for "
        "indices that "
        "hardly differ.",
    .matters =
        "Glass is too bright or too dark; past the critical angle the square root of a negative number gives black or "
        "NaN pixels.",
    .tolerance =
        "Whether reflection is total is free within 4 u of critical. Near it (1e-4 in sin^2) 1e-6 absolute, as R goes "
        "with the "
        "square root of the distance; elsewhere 64 u (R + sqrt R) (1 + 1/c^2), as the amplitudes are off by a few u "
        "and "
        "the refracted cosine c, a square root, by a few u / c^2.",
    .run = run,
};

}  // namespace plumb

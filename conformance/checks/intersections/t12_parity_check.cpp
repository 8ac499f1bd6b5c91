#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "conformance/checks/check.h"
#include "conformance/checks/class_question.h"
#include "conformance/checks/describe.h"
#include "conformance/checks/hit_judge.h"
#include "conformance/families/family.h"

namespace plumb {
namespace {

constexpr double kRays = 30'000;
/// Hits of neighbours at a common edge differ in t by the roundings of two formulas: 64 ulps, as for t elsewhere, times
/// the condition.
constexpr double kMergeUlps = 64;

struct Counts {
  std::int64_t rays = 0, hits = 0, odd = 0, against_truth = 0, too_close = 0;
  std::string worst;
};

/// How many places hits lie at, those within rounding of each other being one.
std::size_t places(std::vector<SubjectHit> hits, double relative) {
  std::ranges::sort(hits, {}, &SubjectHit::t);
  std::size_t count = 0;
  double last = 0;
  for (const SubjectHit& hit : hits) {
    if (count == 0 || hit.t - last > relative * std::max(std::fabs(hit.t), std::fabs(last))) ++count;
    last = hit.t;
  }
  return count;
}

/// The exact crossings: each proper one is a place, and each t at which neighbours meet.
std::size_t exact_places(const ExactHit& truth) {
  std::size_t count = 0;
  const ExactCrossing* last = nullptr;
  for (const ExactCrossing& crossing : truth.crossings) {
    count += !crossing.free || !last || last->t != crossing.t;
    last = crossing.free ? &crossing : nullptr;
  }
  return count;
}

std::size_t places_within(const ExactHit& truth, double relative) {
  std::vector<SubjectHit> hits(truth.crossings.size());
  for (std::size_t i = 0; i < hits.size(); ++i) hits[i].t = truth.crossings[i].t_double;
  return places(std::move(hits), relative);
}

void judge(const FamilyCase& one, const Ray& ray, const std::vector<SubjectHit>& hits, const Contract& contract,
           Counts& counts) {
  const ExactHit truth = exact_hit({one.surface.shape, one.surface.world_from_object}, ray);
  const double relative = kMergeUlps * 2 * unit_roundoff(contract.t_precision) * one.condition;
  const std::size_t found = places(hits, relative);
  const std::size_t exact = exact_places(truth);
  ++counts.rays;
  counts.hits += static_cast<std::int64_t>(hits.size());
  // Where two crossings lie so close together that rounding can merge them, or hardly close enough, no count can be
  // asked.
  if (places_within(truth, 4 * relative) != exact) {
    ++counts.too_close;
    return;
  }
  // A ray that only touches the silhouette's edge meets one place, exactly; any other that begins outside meets an even
  // number.
  const bool free = std::ranges::any_of(truth.crossings, &ExactCrossing::free);
  const bool odd = found % 2 == 1 && !(free && exact % 2 == 1);
  const bool wrong = !free && found != exact;
  counts.odd += odd;
  counts.against_truth += wrong;
  if ((odd || wrong) && counts.worst.empty())
    counts.worst = fmt::format("{} places instead of {} for {}", found, exact,
                               oracle_command({one.surface.shape, one.surface.world_from_object}, ray));
}

CheckResult run(Subject& subject, const CheckOptions& options) {
  const Contract& contract = subject.contract();
  if (!(contract.capabilities & PLUMB_ALL_HITS))
    throw UnsupportedBySubject(subject.name() + " does not report all hits");
  const auto wanted = static_cast<std::int64_t>(std::ceil(kRays * options.intensity * subject.pace()));
  const auto source = family_kind("T12").make(options.seed, family_precision(contract, ShapeKind::mesh));
  Counts counts;
  while (counts.rays < wanted) {
    const FamilyCase one = source->next();
    if (!can_build(contract, one.surface)) throw UnsupportedBySubject(subject.name() + " cannot build meshes");
    subject.load({one.surface});
    const std::vector<std::vector<SubjectHit>> hits = subject.all(one.rays);
    for (std::size_t i = 0; i < one.rays.size(); ++i) judge(one, one.rays[i], hits[i], contract, counts);
    options.progress(static_cast<double>(counts.rays) / static_cast<double>(wanted));
  }
  CheckResult result;
  const std::int64_t wrong = std::max(counts.odd, counts.against_truth);
  result.verdict = wrong == 0 ? Verdict::pass : Verdict::fail;
  result.cause = wrong == 0 ? "" : "parity";
  result.margin = -static_cast<double>(wrong);
  result.evidence = {{"contract", to_string(contract)},
                     {"rays", counts.rays},
                     {"hits", counts.hits},
                     {"odd", counts.odd},
                     {"against_truth", counts.against_truth},
                     {"too_close_to_count", counts.too_close}};
  result.summary =
      fmt::format("{} rays through closed meshes: {} with an odd number of places, {} with another number than exactly",
                  counts.rays, counts.odd, counts.against_truth);
  if (wrong > 0) {
    result.evidence.emplace_back("worst", counts.worst);
    result.advice = "a hit through an edge is lost or counted at two places: " + counts.worst;
  }
  return result;
}

}  // namespace

extern const CheckKind t12_parity_check_kind{
    .id = "T12",
    .title = "All hits through a closed mesh are even",
    .asks =
        "Rays from outside through vertices and edges of closed meshes: every hit, those at one place counted once.",
    .matters =
        "Whether a point is inside, and what lies between two glasses, is found by counting: an odd count turns inside "
        "out.",
    .tolerance =
        "Hits are at one place if their t differ by at most 64 ulps times the condition. The number of places is that "
        "of the distinct exact t, "
        "and even, but where the ray only touches an edge.",
    .run = run,
};

}  // namespace plumb

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

/// A triangle that the ray passes within rounding of an edge of, or through: the sign of its facing, 0 for none or for
/// a ray clear of the edges. The weights are computed in doubles, whose own error is well within the band of 32 u.
int facing_beside_edge(const Ray& ray, const Point3& a, const Point3& b, const Point3& c, double u) {
  const Vec3 to_a = a - ray.origin, to_b = b - ray.origin, to_c = c - ray.origin;
  const double weights[] = {dot(ray.direction, cross(to_c, to_b)), dot(ray.direction, cross(to_a, to_c)),
                            dot(ray.direction, cross(to_b, to_a))};
  const double size = std::max({length(to_a), length(to_b), length(to_c)});
  const double edge = std::max({length(b - a), length(c - b), length(a - c)});
  const double band = 32 * u * 3 * length(ray.direction) * size * edge;
  const auto [low, high] = std::ranges::minmax(weights);
  if (low < -band && high > band) return 0;
  if (std::ranges::none_of(weights, [&](double w) { return std::fabs(w) <= band; })) return 0;
  return high > band ? 1 : low < -band ? -1 : 2;
}

/// Whether rounding may let the ray pass on either side of the silhouette: a front and a back, or a triangle seen
/// edge-on, meet beside it.
bool beside_silhouette(const TriangleMesh& mesh, const Ray& ray, double u) {
  std::vector<int> seen(mesh.positions.size(), 0);
  for (const auto& triangle : mesh.triangles) {
    const auto& p = mesh.positions;
    const int facing = facing_beside_edge(ray, p[triangle[0]], p[triangle[1]], p[triangle[2]], u);
    if (facing == 0) continue;
    for (const std::uint32_t vertex : triangle) {
      if (facing == 2 || (seen[vertex] != 0 && seen[vertex] != facing)) return true;
      seen[vertex] = facing;
    }
  }
  return false;
}

void judge(const FamilyCase& one, const Ray& ray, const std::vector<SubjectHit>& hits, const Contract& contract,
           Counts& counts) {
  const ExactHit truth = exact_hit({one.surface.shape, one.surface.world_from_object}, ray);
  const double relative = kMergeUlps * 2 * unit_roundoff(contract.t_precision) * one.condition;
  const std::size_t found = places(hits, relative);
  const std::size_t exact = exact_places(truth);
  ++counts.rays;
  counts.hits += static_cast<std::int64_t>(hits.size());
  // Where rounding can merge two crossings, or take the ray to the other side of the silhouette, no count is right.
  const double u = unit_roundoff(contract.precision);
  if (places_within(truth, 4 * relative) != exact || beside_silhouette(*one.surface.shape.mesh, ray, u)) {
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
  if (contract.edge_rule == PLUMB_EDGE_NONE)
    throw UnsupportedBySubject(subject.name() + " promises nothing of rays through edges");
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
                     {"not_counted", counts.too_close}};
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
        "of the exact "
        "crossings, and even. Not counted are rays with crossings within rounding of each other, and rays within 32 u "
        "of the silhouette.",
    .run = run,
};

}  // namespace plumb

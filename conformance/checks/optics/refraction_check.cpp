#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "conformance/checks/check.h"
#include "conformance/checks/describe.h"
#include "conformance/checks/hit_judge.h"
#include "conformance/families/aim.h"
#include "reference/exact_optics.h"

namespace plumb {
namespace {

constexpr double kQueries = 10'000;
/// Where sin^2 is this near to critical, the refracted cosine goes with the square root of the distance.
constexpr double kNearCritical = 1e-4;
/// The direction is ratio d + (ratio c - c') n: a few u of each term, and as many u / c' of the refracted cosine c', a
/// square root.
constexpr double kUnits = 64;
/// As for the reflectance 4 u, and as much for each of the roundings of d, of n and of their product.
constexpr double kFreeUnits = 16;

struct Query {
  Vec3 direction, normal;
  double from, to;
};

/// Ordinary angles; about the critical angle, 1e-16 .. 1e-4 to either side; straight on; each a third. In the subject's
/// precision.
Query make_query(Random& random, const Rounding& rounded, std::int64_t i) {
  const double a = 1 + random.unit(), b = 1 + random.unit();
  const double from = i % 3 == 1 ? std::max(a, b) : a, to = i % 3 == 1 ? std::min(a, b) : b;
  double cosine = random.between(0.01, 1);
  if (i % 3 == 1) {
    const double critical = std::sqrt((1 - to / from) * (1 + to / from));
    const double off = random.sign() * random.magnitude(1e-16, 1e-4);
    cosine = std::clamp(critical + off, 0.0, 1.0);
  }
  if (i % 3 == 2) cosine = 1;
  const Vec3 normal = random_direction(random);
  const Vec3 along = random_perpendicular(random, normal);
  const Vec3 direction = std::sqrt((1 - cosine) * (1 + cosine)) * along - cosine * normal;
  return {rounded(direction), rounded(normal), rounded(from), rounded(to)};
}

struct Counts {
  std::int64_t queries = 0, total = 0, free = 0, wrong_decisions = 0, wrong_directions = 0;
  double largest = 0;
  std::string worst;
};

std::string text(const std::optional<Vec3>& v) {
  return v ? fmt::format("({:.17g}, {:.17g}, {:.17g})", v->x, v->y, v->z) : "none";
}

std::string hex_triple(const Vec3& v) { return "(" + hex(v.x) + ", " + hex(v.y) + ", " + hex(v.z) + ")"; }

void judge(const Query& q, const std::optional<Vec3>& claimed, double u, Counts& counts) {
  const std::optional<Vec3> exact = exact_refracted(q.direction, q.normal, q.from, q.to);
  const double cosine = std::clamp(-dot(q.direction, q.normal) / (length(q.direction) * length(q.normal)), 0.0, 1.0);
  const ExactFresnel at = exact_fresnel(cosine, q.from, q.to);
  const bool free = at.distance_to_critical <= kFreeUnits * u;
  ++counts.queries;
  counts.total += !exact;
  counts.free += free;
  double share = 0;
  if (claimed.has_value() != exact.has_value()) {
    if (free) return;
    ++counts.wrong_decisions;
    share = Bounds3::kInfinity;
  } else if (exact) {
    // Past a distance of 1e-4 the refracted cosine is at least 0.01; nearer, its error is at most the root of the
    // distance's.
    const bool near = at.distance_to_critical < kNearCritical;
    const double allowed = near ? 16 * std::sqrt(u) : kUnits * u * (1 + 1 / at.refracted_cosine.below);
    share = length(*claimed - *exact) / allowed;
    if (!(share <= 1)) ++counts.wrong_directions;
  }
  if (!(share <= counts.largest) || counts.worst.empty()) {
    counts.largest = share;
    counts.worst = fmt::format("direction {}, normal {} from {} to {}: {}, exactly {}", hex_triple(q.direction),
                               hex_triple(q.normal), hex(q.from), hex(q.to), text(claimed), text(exact));
  }
}

CheckResult run(Subject& subject, const CheckOptions& options) {
  const Contract& contract = subject.contract();
  if (!contract.refract) throw UnsupportedBySubject(subject.name() + " does not answer refraction");
  const double u = unit_roundoff(contract.precision);
  const Rounding rounded(contract.precision);
  const auto count = static_cast<std::int64_t>(std::ceil(kQueries * options.intensity));
  Counts counts;
  for (std::int64_t i = 0; i < count; ++i) {
    Random random(options.seed, "refraction", static_cast<std::uint64_t>(i));
    const Query q = make_query(random, rounded, i);
    judge(q, subject.refract(q.direction, q.normal, q.from, q.to), u, counts);
    options.progress(static_cast<double>(i + 1) / static_cast<double>(count));
  }
  const std::int64_t wrong = counts.wrong_decisions + counts.wrong_directions;
  CheckResult result;
  result.verdict = wrong == 0 ? Verdict::pass : Verdict::fail;
  result.cause = counts.wrong_decisions > 0 ? "total_reflection" : wrong > 0 ? "direction" : "";
  result.margin = 1 - counts.largest;
  result.evidence = {{"queries", counts.queries},
                     {"total_reflections", counts.total},
                     {"free", counts.free},
                     {"wrong_decisions", counts.wrong_decisions},
                     {"wrong_directions", counts.wrong_directions},
                     {"largest_error_over_allowed", counts.largest},
                     {"worst", counts.worst}};
  result.summary = fmt::format("{} refractions, {} wrong; the worst error is {:.2g} of what is allowed", counts.queries,
                               wrong, counts.largest);
  if (wrong > 0) result.advice = "the worst case: " + counts.worst;
  return result;
}

}  // namespace

extern const CheckKind refraction_check_kind{
    .id = "refraction",
    .title = "Refracted directions",
    .asks = "Where light goes on through an interface, at ordinary angles, about the critical angle and straight on.",
    .matters = "What is seen through glass is bent the wrong way, or black where the refraction is lost.",
    .tolerance =
        "Whether reflection is total is free within 16 u of critical: 4 u of the decision and as much for the "
        "roundings of both "
        "vectors and of their product. Near it (1e-4 in sin^2) 16 sqrt u, as the refracted cosine c goes with the "
        "square "
        "root of the distance; elsewhere 64 u (1 + 1/c).",
    .run = run,
};

}  // namespace plumb

#include "conformance/checks/leak_question.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "conformance/checks/class_question.h"
#include "conformance/checks/describe.h"

namespace plumb {
namespace {

constexpr double kRays = 1'000'000;
constexpr std::size_t kBatch = 20'000;

struct Leaks {
  std::int64_t rays = 0, escapes = 0, surfaces = 0;
  std::string names, worst;
};

bool too_large(const ClosedSurface& closed, const Contract& contract) {
  if (std::isinf(contract.largest) || !closed.surface.shape.mesh) return false;
  return std::ranges::any_of(closed.surface.shape.mesh->positions, [&](const Point3& p) {
    return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) > contract.largest;
  });
}

void shoot(Subject& subject, const ClosedSurface& closed, const std::vector<Ray>& rays, Leaks& leaks) {
  subject.load({closed.surface});
  std::int64_t escapes = 0;
  for (std::size_t from = 0; from < rays.size(); from += kBatch) {
    const auto batch = std::span(rays).subspan(from, std::min(kBatch, rays.size() - from));
    const std::vector<SubjectHit> answers = subject.closest(batch);
    for (std::size_t i = 0; i < batch.size(); ++i) {
      if (answers[i].hit()) continue;
      if (++escapes == 1 && leaks.worst.empty())
        leaks.worst =
            closed.name + ": " + oracle_command({closed.surface.shape, closed.surface.world_from_object}, batch[i]);
    }
  }
  leaks.rays += static_cast<std::int64_t>(rays.size());
  leaks.escapes += escapes;
  ++leaks.surfaces;
  if (escapes > 0) leaks.names += fmt::format("{}{} ({})", leaks.names.empty() ? "" : ", ", closed.name, escapes);
}

}  // namespace

CheckResult check_leaks(std::span<const ClosedSurface> surfaces, Subject& subject, const CheckOptions& options) {
  const Contract& contract = subject.contract();
  if (contract.edge_rule == PLUMB_EDGE_NONE)
    throw UnsupportedBySubject(subject.name() + " promises nothing of rays through edges");
  std::vector<const ClosedSurface*> built;
  for (const ClosedSurface& closed : surfaces)
    if (can_build(contract, closed.surface) && !too_large(closed, contract)) built.push_back(&closed);
  if (built.empty()) throw UnsupportedBySubject(subject.name() + " builds none of these surfaces");

  const auto each = static_cast<std::size_t>(
      std::ceil(kRays * options.intensity * subject.pace() / static_cast<double>(built.size())));
  Leaks leaks;
  for (const ClosedSurface* closed : built) {
    const plumb_precision precision = family_precision(contract, closed->surface.shape.kind);
    shoot(subject, *closed, leak_rays(*closed, options.seed, each, precision), leaks);
    options.progress(static_cast<double>(leaks.surfaces) / static_cast<double>(built.size()));
  }

  CheckResult result;
  result.verdict = leaks.escapes == 0 ? Verdict::pass : Verdict::fail;
  result.cause = leaks.escapes == 0 ? "" : "escape";
  result.margin = -static_cast<double>(leaks.escapes);
  const auto rays = static_cast<double>(leaks.rays);
  result.evidence = {{"contract", to_string(contract)},
                     {"rays", leaks.rays},
                     {"surfaces", leaks.surfaces},
                     {"escapes", leaks.escapes},
                     {"escapes_per_million", 1e6 * static_cast<double>(leaks.escapes) / rays}};
  result.summary = leaks.escapes == 0
                       ? fmt::format("{} rays from inside of {} surfaces, 0 escape (< {:.3g} per million at 95 %)",
                                     leaks.rays, leaks.surfaces, 3e6 / rays)
                       : fmt::format("{} of {} rays from inside escape: {}", leaks.escapes, leaks.rays, leaks.names);
  if (leaks.escapes > 0) {
    result.evidence.emplace_back("where", leaks.names);
    result.evidence.emplace_back("worst", leaks.worst);
    result.advice = "light leaks out of closed surfaces; the first: " + leaks.worst;
  }
  return result;
}

}  // namespace plumb

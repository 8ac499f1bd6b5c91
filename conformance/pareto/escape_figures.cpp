#include "conformance/pareto/escape_figures.h"

#include <algorithm>
#include <optional>

#include "conformance/pareto/percentile.h"
#include "reference/exact_hit.h"

namespace plumb {

EscapeTally::EscapeTally(MeshAim aim, plumb_precision precision) : precision_(precision) {
  figure_.aim = to_string(aim);
}

void EscapeTally::judge(const ClosedSurface& closed, std::span<const Ray> rays, std::span<const SubjectHit> answers) {
  const Shape& shape = closed.surface.shape;
  std::int64_t escapes = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (answers[i].hit()) continue;
    ++escapes;
    const ExactHit truth = exact_hit({shape}, rays[i]);
    for (const ExactCrossing& crossing : truth.crossings) {
      margins_.push_back(mesh_margin(rays[i], *shape.mesh, crossing.part, precision_));
      break;
    }
  }
  ++figure_.meshes;
  figure_.rays += static_cast<std::int64_t>(rays.size());
  figure_.escapes += escapes;
  if (escapes <= worst_) return;
  worst_ = escapes;
  figure_.worst_mesh = closed.name;
}

EscapeFigure EscapeTally::figure() && {
  std::ranges::sort(margins_);
  figure_.median_u = percentile(margins_, 0.5);
  figure_.farthest_u = percentile(margins_, 1);
  return std::move(figure_);
}

std::vector<EscapeFigure> escape_figures(std::span<Contender* const> contenders, std::span<const ClosedSurface> meshes,
                                         MeshAim aim, std::uint64_t seed, std::int64_t count,
                                         const std::function<void(double)>& progress) {
  if (contenders.empty()) return {};
  const auto fresh_tally = [&](const Contender& contender) {
    return EscapeTally(aim, contender.subject->contract().precision);
  };
  std::vector<std::optional<EscapeTally>> tallies;
  for (const Contender* contender : contenders) tallies.emplace_back(fresh_tally(*contender));
  const auto total = static_cast<std::int64_t>(meshes.size());
  const auto each = static_cast<std::size_t>((count + total - 1) / total);
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const ClosedSurface& closed = meshes[m];
    const std::vector<Ray> rays =
        rays_from_inside(closed.name, *closed.surface.shape.mesh, aim, seed, each, contenders.front()->inputs);
    for (std::size_t k = 0; k < contenders.size(); ++k) {
      if (!tallies[k]) continue;
      Contender& contender = *contenders[k];
      const bool answered = contender.attempt("escapes", [&] {
        contender.subject->load({closed.surface});
        tallies[k]->judge(closed, rays, contender.subject->closest(rays));
      });
      if (!answered) tallies[k].reset();
    }
    progress(static_cast<double>(m + 1) / static_cast<double>(meshes.size()));
  }
  std::vector<EscapeFigure> figures;
  for (std::size_t k = 0; k < contenders.size(); ++k) {
    if (!tallies[k]) tallies[k].emplace(fresh_tally(*contenders[k]));
    figures.push_back(std::move(*tallies[k]).figure());
  }
  return figures;
}

}  // namespace plumb

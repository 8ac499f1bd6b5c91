#include "conformance/pareto/closest_figures.h"

#include <algorithm>
#include <memory>

#include "conformance/checks/hit_judge.h"
#include "conformance/families/closed_meshes.h"
#include "conformance/families/rounding.h"
#include "meshes/generators/icosphere.h"

namespace plumb {
namespace {

constexpr std::size_t kBatch = 2000;

SubjectSurface mesh_surface(TriangleMesh mesh) {
  SubjectSurface surface;
  surface.shape.kind = ShapeKind::mesh;
  surface.shape.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
  return surface;
}

TriangleMesh shells(const Rounding& rounded) {
  TriangleMesh inner = icosphere(2);
  inner.normals.clear();
  for (Point3& p : inner.positions) p = rounded(p);
  TriangleMesh both = inner;
  const auto first = static_cast<std::uint32_t>(inner.positions.size());
  for (const Point3& p : inner.positions) both.positions.push_back(rounded(Point3{} + (1 + 0x1p-20) * (p - Point3{})));
  for (const auto& [a, b, c] : inner.triangles) both.triangles.push_back({a + first, b + first, c + first});
  return both;
}

Shape triangle_of(const TriangleMesh& mesh, std::uint32_t index) {
  const auto& [a, b, c] = mesh.triangles[index];
  Shape triangle;
  triangle.vertices = {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
  return triangle;
}

}  // namespace

std::vector<ClosestScene> closest_scenes(plumb_precision precision) {
  std::vector<ClosestScene> scenes;
  for (const ClosedSurface& closed : closed_meshes(precision)) {
    if (closed.name == "icosphere-320") scenes.push_back({"sphere", closed.surface});
    if (closed.name == "cube-8") scenes.push_back({"cube", closed.surface});
  }
  scenes.push_back({"shells", mesh_surface(shells(Rounding(precision)))});
  return scenes;
}

ClosestFault closest_fault(const ExactClosest& truth, const TriangleMesh& mesh, const Ray& ray,
                           const SubjectHit& answer) {
  if (!answer.hit()) return truth.winners.empty() ? ClosestFault::none : ClosestFault::missed;
  const auto is_answer = [&](const ExactClosest::Entry& entry) { return entry.crossing.part == answer.primitive; };
  if (std::ranges::any_of(truth.winners, is_answer) || std::ranges::any_of(truth.free_nearer, is_answer))
    return ClosestFault::none;
  const bool is_met = !exact_hit({triangle_of(mesh, answer.primitive)}, ray).crossings.empty();
  return is_met ? ClosestFault::behind : ClosestFault::beside;
}

ClosestTally::ClosestTally(const ClosestScene& scene, MeshAim aim, const Contract& contract)
    : mesh_(*scene.surface.shape.mesh), contract_(contract) {
  figure_.scene = scene.name;
  figure_.aim = to_string(aim);
}

void ClosestTally::judge(const Ray& ray, const ExactClosest& truth, const SubjectHit& answer) {
  ++figure_.rays;
  figure_.ties += truth.winners.size() > 1 || !truth.free_nearer.empty();
  const ClosestFault fault = closest_fault(truth, mesh_, ray, answer);
  figure_.missed += fault == ClosestFault::missed;
  figure_.beside += fault == ClosestFault::beside;
  figure_.behind += fault == ClosestFault::behind;
  if (fault == ClosestFault::behind) {
    const double ulps = t_error_ulps(answer.t, truth.winners.front().crossing, contract_.t_precision);
    figure_.farthest_ulps = std::max(figure_.farthest_ulps, ulps);
  } else if (fault != ClosestFault::none) {
    const std::uint32_t blamed = fault == ClosestFault::beside ? answer.primitive : truth.winners.front().crossing.part;
    figure_.farthest_u = std::max(figure_.farthest_u, mesh_margin(ray, mesh_, blamed, contract_.precision));
  }
}

std::vector<ClosestFigure> closest_figures(std::span<Contender* const> contenders, const ClosestScene& scene,
                                           MeshAim aim, std::uint64_t seed, std::int64_t count,
                                           const std::function<void(double)>& progress) {
  if (contenders.empty()) return {};
  const std::vector<Ray> rays = rays_from_outside(scene.name, *scene.surface.shape.mesh, aim, seed,
                                                  static_cast<std::size_t>(count), contenders.front()->inputs);
  std::vector<std::vector<SubjectHit>> answers(contenders.size());
  for (std::size_t k = 0; k < contenders.size(); ++k) {
    Contender& contender = *contenders[k];
    contender.attempt("closest surface", [&] {
      contender.subject->load({scene.surface});
      answers[k] = contender.subject->closest(rays);
    });
    progress(0.5 * static_cast<double>(k + 1) / static_cast<double>(contenders.size()));
  }
  std::vector<ClosestTally> tallies;
  for (const Contender* contender : contenders) tallies.emplace_back(scene, aim, contender->subject->contract());
  const PlacedShape shape{scene.surface.shape, scene.surface.world_from_object};
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const ExactClosest truth = exact_closest(std::span(&shape, 1), rays[i]);
    for (std::size_t k = 0; k < contenders.size(); ++k)
      if (!answers[k].empty()) tallies[k].judge(rays[i], truth, answers[k][i]);
    if (i % kBatch == 0) progress(0.5 + 0.5 * static_cast<double>(i) / static_cast<double>(rays.size()));
  }
  std::vector<ClosestFigure> figures;
  for (ClosestTally& tally : tallies) figures.push_back(std::move(tally).figure());
  return figures;
}

}  // namespace plumb

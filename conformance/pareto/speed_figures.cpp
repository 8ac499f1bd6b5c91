#include "conformance/pareto/speed_figures.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "conformance/families/aim.h"
#include "meshes/generators/icosphere.h"

namespace plumb {
namespace {

constexpr std::size_t kFirstRays = 1000;

/// One contender between its rounds.
struct Runner {
  Contender* contender;
  std::vector<double> rounds;
  std::size_t rays = 0;
};

/// In million rays a second of CPU time; 0 where the time cannot be told.
double speed_of(Subject& subject, std::span<const Ray> rays) {
  subject.closest(rays);
  const double seconds = subject.last_cpu_seconds().value_or(0);
  return seconds > 0 ? static_cast<double>(rays.size()) / seconds * 1e-6 : 0;
}

}  // namespace

SpeedScene speed_mesh(const Rounding& rounded) {
  constexpr int kSubdivisions = 5;
  TriangleMesh mesh = icosphere(kSubdivisions);
  mesh.normals.clear();
  for (Point3& p : mesh.positions) p = rounded(p);
  SubjectSurface surface;
  surface.shape.kind = ShapeKind::mesh;
  surface.shape.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
  return {"an icosphere of 20,480 triangles", {surface}};
}

SpeedScene speed_spheres(const Rounding& rounded) {
  constexpr int kSpheres = 1000;
  SpeedScene scene{"1,000 spheres of radius 0.02 to 0.08 in a cube of side 2", {}};
  for (std::uint64_t i = 0; i < kSpheres; ++i) {
    Random random(1, "speed spheres", i);
    SubjectSurface sphere;
    sphere.shape.kind = ShapeKind::sphere;
    sphere.shape.center = rounded(random_point(random, -1, 1));
    sphere.shape.radius = rounded(random.between(0.02, 0.08));
    scene.surfaces.push_back(sphere);
  }
  return scene;
}

std::vector<Ray> speed_rays(std::uint64_t seed, std::size_t count, const Rounding& rounded) {
  std::vector<Ray> rays;
  rays.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    Random random(seed, "speed", i);
    const Point3 origin = rounded(random_point(random, -4, 4));
    rays.push_back(ray_to(origin, random_point(random, -1, 1), rounded));
  }
  return rays;
}

SpeedFigure speed_figure(std::int64_t rays, std::vector<double> rounds) {
  if (rounds.empty()) return {};
  std::ranges::sort(rounds);
  const std::size_t middle = rounds.size() / 2;
  const double median = rounds.size() % 2 ? rounds[middle] : (rounds[middle - 1] + rounds[middle]) / 2;
  return {rays, static_cast<int>(rounds.size()), median, rounds.front(), rounds.back()};
}

std::vector<SpeedFigure> speed_figures(std::span<Contender> contenders, SpeedScene (*scene)(const Rounding&),
                                       const SpeedPlan& plan, std::uint64_t seed,
                                       const std::function<void(double)>& progress) {
  std::vector<Ray> rays_by_inputs[2];
  const auto rays_of = [&](const Contender& contender) -> const std::vector<Ray>& {
    std::vector<Ray>& rays = rays_by_inputs[contender.inputs == PLUMB_FLOAT ? 0 : 1];
    if (rays.empty()) rays = speed_rays(seed, plan.rays, Rounding(contender.inputs));
    return rays;
  };
  std::vector<Runner> runners;
  for (Contender& contender : contenders) {
    Runner runner{&contender, {}, 0};
    contender.attempt("speed", [&] {
      contender.subject->load(scene(Rounding(contender.inputs)).surfaces);
      const std::span<const Ray> rays = rays_of(contender);
      const double first = speed_of(*contender.subject, rays.first(std::min(kFirstRays, rays.size())));
      const double affordable = std::max(1e6 * first * plan.seconds, static_cast<double>(kFirstRays));
      if (first > 0) runner.rays = static_cast<std::size_t>(std::min(affordable, static_cast<double>(rays.size())));
    });
    runners.push_back(std::move(runner));
  }
  for (int round = 0; round < plan.rounds; ++round) {
    for (Runner& runner : runners) {
      if (runner.rays == 0) continue;
      const auto rays = std::span(rays_of(*runner.contender)).first(runner.rays);
      const auto ask = [&] { runner.rounds.push_back(speed_of(*runner.contender->subject, rays)); };
      if (!runner.contender->attempt("speed", ask)) runner = {runner.contender, {}, 0};
    }
    progress(static_cast<double>(round + 1) / plan.rounds);
  }
  std::vector<SpeedFigure> figures;
  for (Runner& runner : runners)
    figures.push_back(speed_figure(static_cast<std::int64_t>(runner.rays), std::move(runner.rounds)));
  return figures;
}

}  // namespace plumb

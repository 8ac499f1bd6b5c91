// What a ray costs by the size of the mesh, by both ways to search: the hierarchy's time must grow far more slowly. CPU
// time; the sizes and the two ways run in one process, so that their ratios mean something.

#include <benchmark/benchmark.h>

#include <fstream>
#include <memory>
#include <string>

#include "meshes/generators/icosphere.h"
#include "renderer/accel/accelerator.h"
#include "renderer/math/bounds3.h"
#include "renderer/surfaces/closest_triangle.h"

namespace plumb {
namespace {

/// Rays from outside at a 64 x 64 grid over the sphere's square, in a fixed order.
Ray grid_ray(std::size_t i) {
  const double x = (static_cast<double>(i % 64) + 0.5) / 32 - 1;
  const double y = (static_cast<double>(i / 64 % 64) + 0.5) / 32 - 1;
  return {{0, 0, 3}, {x, y, -3}};
}

void closest_hit(benchmark::State& state, Accel accel) {
  const TriangleMesh mesh = icosphere(static_cast<int>(state.range(0)));
  const Accelerator accelerator(accel, triangle_bounds(mesh));
  TraceCounters counters;
  std::size_t i = 0;
  for (auto _ : state) {
    Ray ray = grid_ray(i++);
    const PlacedRay placed(ray);
    ClosestTriangle closest(placed, mesh, 1);
    accelerator.walk(ray, counters, [&](std::uint32_t triangle) {
      closest.offer(triangle);
      ray.t_max = closest.t_max();
      return false;
    });
    benchmark::DoNotOptimize(closest.result());
  }
  state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
  state.counters["nodes/ray"] =
      benchmark::Counter(static_cast<double>(counters.node_visits), benchmark::Counter::kAvgIterations);
}

void build(benchmark::State& state) {
  const TriangleMesh mesh = icosphere(static_cast<int>(state.range(0)));
  const std::vector<Bounds3> bounds = triangle_bounds(mesh);
  for (auto _ : state) benchmark::DoNotOptimize(Hierarchy(bounds).node_count());
  state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
}

BENCHMARK_CAPTURE(closest_hit, linear, Accel::linear)->DenseRange(2, 4);
BENCHMARK_CAPTURE(closest_hit, bvh2, Accel::bvh2)->DenseRange(2, 7);
BENCHMARK(build)->DenseRange(4, 7)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace plumb

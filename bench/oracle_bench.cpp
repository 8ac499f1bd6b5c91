// What an exact decision between a ray and a triangle costs on one thread, beside Moller-Trumbore in plain doubles on
// the same pairs in the same run. Easy pairs are random ones; the lattice is all degenerate: every ray is aimed exactly
// at a vertex or an edge, and the coordinates carry an offset that makes them use all 53 bits.

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <ctime>
#include <memory>
#include <random>
#include <vector>

#include "meshes/generators/icosphere.h"
#include "reference/exact_hit.h"
#include "reference/triangle_oracle.h"

namespace plumb {
namespace {

struct Pair {
  Ray ray;
  std::array<Point3, 3> triangle;
};

/// Too many for the branch predictor to learn, few enough for the second-level cache.
constexpr std::size_t kPairs = 8192;

class PairMaker {
 public:
  double uniform() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  Pair easy() {
    Pair pair;
    for (Point3& p : pair.triangle) p = {uniform(), uniform(), uniform()};
    pair.ray.origin = {3 * uniform(), 3 * uniform(), 3 * uniform()};
    pair.ray.direction = Point3{uniform(), uniform(), uniform()} - pair.ray.origin;
    return pair;
  }

  /// Random numbers of 53 bits, the ray aimed at an edge as well as it can: the differences need two doubles.
  Pair edge() {
    Pair pair = easy();
    const auto& [a, b, c] = pair.triangle;
    pair.ray.direction = a + 0.5 * (uniform() + 1) * (b - a) - pair.ray.origin;
    return pair;
  }

  /// Integers from -4 to 4 plus an offset with odd last bits of 2^-22 at 2^30. The origin has bits below the lattice
  /// where `fine` is set; in either case target - origin is exact.
  Pair lattice(bool fine) {
    const double step = 0x1p-22;
    const Point3 offset{0x1p30 - 77 + step, 0x1p30 - 3001 + 3 * step, 0x1p30 - 5 + 5 * step};
    const auto point = [&](int reach) {
      return offset + Vec3{double(whole(-reach, reach)), double(whole(-reach, reach)), double(whole(-reach, reach))};
    };
    Pair pair;
    for (Point3& p : pair.triangle) p = point(4);
    pair.ray.origin = point(9);
    if (fine)
      for (int i = 0; i < 3; ++i) pair.ray.origin[i] += step * whole(-1000000, 1000000);
    const auto& [a, b, c] = pair.triangle;
    pair.ray.direction = (whole(0, 1) == 0 ? a : a + 0.5 * (b - a)) - pair.ray.origin;
    if (pair.ray.direction == Vec3()) pair.ray.direction = {1, 0, 0};
    return pair;
  }

 private:
  std::mt19937_64 random_{1};
};

enum class Kind { easy, edge, lattice, fine_lattice };

const std::vector<Pair>& pairs(Kind kind) {
  static const auto made = [] {
    std::array<std::vector<Pair>, 4> result;
    PairMaker maker;
    for (std::size_t i = 0; i < kPairs; ++i) {
      result[0].push_back(maker.easy());
      result[1].push_back(maker.edge());
      result[2].push_back(maker.lattice(false));
      result[3].push_back(maker.lattice(true));
    }
    return result;
  }();
  return made[static_cast<std::size_t>(kind)];
}

/// The textbook form, culling nothing; wrong where rounding makes it so. All conditions are met at the end: leaving
/// early is slower on pairs that no branch predictor can foresee.
bool moller_trumbore(const Ray& ray, const Point3& a, const Point3& b, const Point3& c) {
  const Vec3 e1 = b - a, e2 = c - a, s = ray.origin - a;
  const Vec3 p = cross(ray.direction, e2), q = cross(s, e1);
  const double det = dot(e1, p);
  const double inverse = 1 / det;
  const double u = inverse * dot(s, p), v = inverse * dot(ray.direction, q), t = inverse * dot(e2, q);
  return (det != 0) & (u >= 0) & (v >= 0) & (u + v <= 1) & (t >= ray.t_min) & (t <= ray.t_max);
}

bool oracle(const Ray& ray, const Point3& a, const Point3& b, const Point3& c, StageCounters& counters) {
  return decide_triangle(ray, a, b, c, counters).hit_class != HitClass::miss;
}

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The CPU time of `test` on all pairs, and how many of them it calls a hit. They are read once before,
/// untimed, so that the cache holds them.
template <class Test>
double time_of(const std::vector<Pair>& pairs, std::size_t& hits, const Test& test) {
  std::size_t ignored = 0;
  for (const Pair& pair : pairs) ignored += static_cast<std::size_t>(pair.ray.direction.x > pair.triangle[2].z);
  benchmark::DoNotOptimize(ignored);
  const double start = cpu_seconds();
  for (const Pair& pair : pairs) hits += test(pair.ray, pair.triangle[0], pair.triangle[1], pair.triangle[2]);
  benchmark::DoNotOptimize(hits);
  return cpu_seconds() - start;
}

/// Both in turn on the same pairs, so that what else the machine does falls on both.
void decide(benchmark::State& state, Kind kind) {
  const std::vector<Pair>& all = pairs(kind);
  StageCounters counters;
  double exact_time = 0, plain_time = 0;
  std::size_t exact_hits = 0, plain_hits = 0;
  for (auto _ : state) {
    const double exact =
        time_of(all, exact_hits, [&](const Ray& ray, const Point3& a, const Point3& b, const Point3& c) {
          return oracle(ray, a, b, c, counters);
        });
    plain_time += time_of(all, plain_hits, moller_trumbore);
    exact_time += exact;
    state.SetIterationTime(exact);
  }
  const double count = static_cast<double>(state.iterations()) * kPairs;
  const double decided = static_cast<double>(counters.filter + counters.expansion + counters.rational);
  state.counters["exact Mpairs/s"] = 1e-6 * count / exact_time;
  state.counters["plain Mpairs/s"] = 1e-6 * count / plain_time;
  state.counters["exact/plain time"] = exact_time / plain_time;
  state.counters["undecided by filter"] = 1 - static_cast<double>(counters.filter) / decided;
  state.counters["exact hits"] = static_cast<double>(exact_hits) / count;
  state.counters["plain hits"] = static_cast<double>(plain_hits) / count;
}

/// exact_hit() on one triangle, hits with all their numbers.
void answer(benchmark::State& state, Kind kind, ExactPath path) {
  const std::vector<Pair>& all = pairs(kind);
  std::size_t i = 0;
  PlacedShape shape;
  for (auto _ : state) {
    const Pair& pair = all[i++ % kPairs];
    shape.shape.vertices = pair.triangle;
    benchmark::DoNotOptimize(exact_hit(shape, pair.ray, path));
  }
}

/// exact_hit() on a mesh, in world space or under a matrix.
void mesh(benchmark::State& state, bool placed) {
  PlacedShape shape;
  shape.shape.kind = ShapeKind::mesh;
  shape.shape.mesh = std::make_shared<const TriangleMesh>(icosphere(3));
  if (placed) shape.world_from_object = {{{1, 0.5, 0, 0}, {0, -1, 0.25, 0}, {0.125, 0, 1, 0}}};
  PairMaker maker;
  std::size_t crossings = 0;
  for (auto _ : state) {
    const Point3 origin{3 * maker.uniform(), 3 * maker.uniform(), 3};
    const Point3 target{maker.uniform(), maker.uniform(), 0};
    crossings += exact_hit(shape, {origin, target - origin}).crossings.size();
  }
  state.counters["triangles"] = static_cast<double>(shape.shape.mesh->triangles.size());
  state.counters["crossings/ray"] =
      benchmark::Counter(static_cast<double>(crossings), benchmark::Counter::kAvgIterations);
}

BENCHMARK_CAPTURE(decide, easy, Kind::easy)->UseManualTime();
BENCHMARK_CAPTURE(decide, edge, Kind::edge)->UseManualTime();
BENCHMARK_CAPTURE(decide, lattice, Kind::lattice)->UseManualTime();
BENCHMARK_CAPTURE(decide, fine_lattice, Kind::fine_lattice)->UseManualTime();
BENCHMARK_CAPTURE(answer, easy, Kind::easy, ExactPath::filtered);
BENCHMARK_CAPTURE(answer, lattice, Kind::lattice, ExactPath::filtered);
BENCHMARK_CAPTURE(answer, edge_filtered, Kind::edge, ExactPath::filtered);
BENCHMARK_CAPTURE(answer, edge_polynomial, Kind::edge, ExactPath::polynomial);
BENCHMARK_CAPTURE(answer, edge_rational, Kind::edge, ExactPath::rational);
BENCHMARK_CAPTURE(mesh, world, false);
BENCHMARK_CAPTURE(mesh, placed, true);

}  // namespace
}  // namespace plumb

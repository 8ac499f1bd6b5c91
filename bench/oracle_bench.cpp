// What an exact decision between a ray and a triangle costs on one thread, beside Moller-Trumbore in plain doubles on
// the same pairs in the same run. Easy pairs are random ones; the lattice is all degenerate: every ray is aimed exactly
// at a vertex or an edge, and the coordinates carry an offset that makes them use all 53 bits.

#include <benchmark/benchmark.h>

#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <random>
#include <vector>

#include "reference/triangle_oracle.h"

namespace plumb {
namespace {

struct Pair {
  Ray ray;
  std::array<Point3, 3> triangle;
};

constexpr std::size_t kPairs = 4096;

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

enum class Kind { easy, lattice, fine_lattice };

const std::vector<Pair>& pairs(Kind kind) {
  static const auto made = [] {
    std::array<std::vector<Pair>, 3> result;
    PairMaker maker;
    for (std::size_t i = 0; i < kPairs; ++i) {
      result[0].push_back(maker.easy());
      result[1].push_back(maker.lattice(false));
      result[2].push_back(maker.lattice(true));
    }
    return result;
  }();
  return made[static_cast<std::size_t>(kind)];
}

/// Textbook form, culling nothing; wrong where rounding makes it so.
bool moller_trumbore(const Ray& ray, const Point3& a, const Point3& b, const Point3& c) {
  const Vec3 e1 = b - a, e2 = c - a;
  const Vec3 p = cross(ray.direction, e2);
  const double det = dot(e1, p);
  if (det == 0) return false;
  const double inverse = 1 / det;
  const Vec3 s = ray.origin - a;
  const double u = inverse * dot(s, p);
  if (u < 0 || u > 1) return false;
  const Vec3 q = cross(s, e1);
  const double v = inverse * dot(ray.direction, q);
  if (v < 0 || u + v > 1) return false;
  return ray.contains(inverse * dot(e2, q));
}

bool oracle(const Ray& ray, const Point3& a, const Point3& b, const Point3& c, StageCounters& counters) {
  return decide_triangle(ray, a, b, c, counters).hit_class != HitClass::miss;
}

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The CPU time of `test` on all pairs, and how many of them it calls a hit.
template <class Test>
double time_of(const std::vector<Pair>& pairs, std::size_t& hits, const Test& test) {
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

BENCHMARK_CAPTURE(decide, easy, Kind::easy)->UseManualTime();
BENCHMARK_CAPTURE(decide, lattice, Kind::lattice)->UseManualTime();
BENCHMARK_CAPTURE(decide, fine_lattice, Kind::fine_lattice)->UseManualTime();

}  // namespace
}  // namespace plumb

// Whether the 8-wide hierarchy finds the same hits by every instruction set: for each that the processor has, a hash of
// the triangles and one of the bits of t, u and v; and how many nodes were looked at, which fused operations may
// change. tools/developer/neon.sh compares ARM's.
//
//   same_hits [RAYS]     that many of each mesh [20000]

#include <hwy/targets.h>

#include <algorithm>
#include <bit>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

#include "meshes/generators/icosphere.h"
#include "meshes/generators/mesh_kind.h"
#include "meshes/generators/random_bits.h"
#include "renderer/accel/bvh8.h"
#include "renderer/math/single_precision.h"

namespace plumb {

extern const MeshKind city_kind;

namespace {

/// FNV-1a over words.
class Hash {
 public:
  void add(std::uint64_t word) { state_ = (state_ ^ mixed_bits(word)) * 0x100000001b3u; }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325u;
};

template <class Triple>
Triple in_floats(const Triple& v) {
  return {rounded_to_single(v.x), rounded_to_single(v.y), rounded_to_single(v.z)};
}

TriangleMesh in_floats(TriangleMesh mesh) {
  for (Point3& p : mesh.positions) p = in_floats(p);
  return mesh;
}

/// In floats, in turn at a vertex, an edge and the inside of a triangle, from anywhere within about `reach`.
std::vector<Ray> aimed_rays(const TriangleMesh& mesh, std::size_t count) {
  RandomBits random(5, mesh.triangles.size());
  double reach = 0;
  for (const Point3& p : mesh.positions) reach = std::max({reach, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.between(-2, 2), y = random.between(-2, 2), z = random.between(-2, 2);
    const auto& [a, b, c] = mesh.triangles[random.bits() % mesh.triangles.size()];
    const double v = i % 3 > 0 ? 0.5 * random.unit() : 0, w = i % 3 > 1 ? 0.5 * random.unit() : 0;
    const Point3& p = mesh.positions[a];
    const Point3 target = p + (v * (mesh.positions[b] - p) + w * (mesh.positions[c] - p));
    const Point3 from = in_floats(Point3{reach * x, reach * y, reach * z});
    rays.push_back({from, in_floats(target - from)});
  }
  return rays;
}

struct Asked {
  std::vector<Bvh8> hierarchies;
  std::vector<std::vector<Ray>> rays;
  void add(const TriangleMesh& mesh, std::size_t count) {
    hierarchies.emplace_back(std::make_shared<const TriangleMesh>(mesh));
    rays.push_back(aimed_rays(mesh, count));
  }
};

void print_hashes(const char* target, const Asked& asked) {
  Hash triangles, numbers;
  std::uint64_t hits = 0, blocked = 0;
  TraceCounters counters;
  for (std::size_t i = 0; i < asked.hierarchies.size(); ++i) {
    for (const Ray& ray : asked.rays[i]) {
      const auto hit = asked.hierarchies[i].closest(PlacedRay(ray), counters);
      const bool any = asked.hierarchies[i].any(PlacedRay(ray), counters);
      triangles.add(hit ? hit->part + std::uint64_t{1} : 0);
      hits += hit.has_value();
      blocked += any;
      if (!hit) continue;
      for (const double number : {hit->t, hit->u, hit->v}) numbers.add(number);
    }
  }
  std::printf(
      "%-8s hits %" PRIu64 " blocked %" PRIu64 " triangles %016" PRIx64 " numbers %016" PRIx64 " nodes %" PRIu64 "\n",
      target, hits, blocked, triangles.value(), numbers.value(), static_cast<std::uint64_t>(counters.node_visits));
}

/// The hierarchies are for the instruction set that is chosen when they are made.
void print_hashes(const char* target, std::size_t count) {
  Asked asked;
  asked.add(in_floats(icosphere(4)), count);
  asked.add(icosphere(3), count);
  asked.add(in_floats(city_kind.make({.triangles = 20000, .progress = {}})), count);
  print_hashes(target, asked);
}

int run(std::size_t count) {
#ifdef HWY_COMPILE_ONLY_STATIC
  print_hashes(hwy::TargetName(HWY_STATIC_TARGET), count);
#else
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::GetChosenTarget().Update(target);
    print_hashes(hwy::TargetName(target), count);
    hwy::GetChosenTarget().DeInit();
  }
#endif
  return 0;
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) { return plumb::run(argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 20000); }

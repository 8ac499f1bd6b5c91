#include "bench/race/arena.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bench/race/race_meshes.h"
#include "renderer/surfaces/triangle.h"

namespace plumb::bench {
namespace {

/// Two triangles that the ray meets at one point have the same exact t; the computed ones differ by the rounding of
/// their planes' determinants, 2^-53 times their condition, which these meshes keep far below 2^20. A float's last
/// place, in which the others err, is 2^-24.
constexpr double kTie = 0x1p-32;

bool is_other(const Found& found, const Found& exact, const Ray& ray, const TriangleMesh& mesh) {
  if (found.hit() != exact.hit()) return true;
  if (!found.hit() || found.triangle == exact.triangle) return false;
  const auto [a, b, c] = mesh.triangles.at(found.triangle);
  const auto& p = mesh.positions;
  const auto hit = intersect_triangle(ShearedRay(ray), p[a], p[b], p[c]);
  return !hit || hit->t - exact.t > kTie * std::fabs(exact.t);
}

/// Well above the rounding of a float's t, which makes a neighbour of the right triangle.
bool is_escape(const Found& found, const Found& exact) {
  return exact.hit() && (!found.hit() || found.t - exact.t > 1e-3 * std::fabs(exact.t));
}

}  // namespace

Arena::Arena(std::shared_ptr<const TriangleMesh> mesh) : mesh_(std::move(mesh)) {
  for (const PeerKind& kind : peer_kinds()) {
    if (mesh_->triangles.size() > kind.most_triangles) continue;
    BuildCost ignored;
    contestants_.push_back({&kind, kind.build(mesh_, 1, ignored)});
  }
}

const Peer& Arena::peer(std::string_view name) const {
  for (const Contestant& contestant : contestants_)
    if (contestant.kind->name == name) return *contestant.peer;
  throw std::out_of_range("no contestant is called " + std::string(name));
}

const RaySet& Arena::rays(std::string_view name, std::size_t count) {
  auto found = sets_.find(name);
  if (found == sets_.end()) {
    const Peer& judge = peer(kJudge);
    RaySet one;
    const auto closest = [&](const Ray& ray) {
      one.rays = {ray};
      return judge.closest_of(one, 0);
    };
    found = sets_.emplace(name, make_ray_set(name, *mesh_, count, closest)).first;
  }
  return found->second;
}

Arena& arena_of(const std::string& mesh) {
  static std::string kept;
  static std::unique_ptr<Arena> arena;
  if (!arena || kept != mesh) {
    arena.reset();
    arena = std::make_unique<Arena>(race_mesh(mesh));
    kept = mesh;
  }
  return *arena;
}

Slice slice_for(const PeerKind& kind, const RaySet& set) {
  const std::size_t count = set.rays.size();
  return {0, count, std::max<std::size_t>(1, (count + kind.most_rays - 1) / kind.most_rays)};
}

Tally ask(const Peer& peer, const RaySet& set, const Slice& slice) {
  return set.question == Question::any ? peer.any(set, slice) : peer.closest(set, slice);
}

double seconds_a_ray(const Contestant& contestant, const RaySet& set) {
  const Slice all = slice_for(*contestant.kind, set);
  const Slice some{0, std::min<std::size_t>(all.end, 4096), all.step};
  benchmark::DoNotOptimize(ask(*contestant.peer, set, some));
  const double start = seconds_on(CLOCK_THREAD_CPUTIME_ID);
  benchmark::DoNotOptimize(ask(*contestant.peer, set, all));
  return (seconds_on(CLOCK_THREAD_CPUTIME_ID) - start) / static_cast<double>(all.count());
}

Differences differences(const Contestant& contestant, const Peer& judge, const RaySet& set, const TriangleMesh& mesh) {
  const Slice slice = slice_for(*contestant.kind, set);
  Differences found;
  for (std::size_t i = slice.begin; i < slice.end; i += slice.step) {
    if (set.question == Question::any) {
      const bool blocked = contestant.peer->any_of(set, i), exact = judge.any_of(set, i);
      found.all += blocked != exact;
      found.escapes += exact && !blocked;
      continue;
    }
    const Found answer = contestant.peer->closest_of(set, i), exact = judge.closest_of(set, i);
    if (!is_other(answer, exact, set.rays[i], mesh)) continue;
    ++found.all;
    found.escapes += is_escape(answer, exact);
  }
  return found;
}

}  // namespace plumb::bench

// The wide hierarchy. CMake takes this file where renderer/accel/bvh8.h is there. Other
// variants (plain leaves in the same hierarchy) are further rows of the list at the end.
#include "renderer/accel/bvh8.h"

#include <optional>

#include "bench/peers/roster.h"

namespace plumb::bench {
namespace {

class Bvh8Peer : public PeerLoops<Bvh8Peer> {
 public:
  Bvh8Peer(std::shared_ptr<const TriangleMesh> mesh, const Bvh8Options& options, BuildCost& cost) {
    timed_build(cost, [&] { bvh_.emplace(std::move(mesh), options); });
  }

  Found closest_of(const RaySet& set, std::size_t ray) const override {
    TraceCounters counters;
    const auto hit = bvh_->closest(PlacedRay(set.rays[ray]), counters);
    return hit ? Found{hit->t, hit->part} : Found{};
  }
  bool any_of(const RaySet& set, std::size_t ray) const override {
    TraceCounters counters;
    return bvh_->any(PlacedRay(set.rays[ray]), counters);
  }
  std::size_t bytes() const override { return bvh_->bytes(); }

 private:
  std::optional<Bvh8> bvh_;
};

std::unique_ptr<Peer> build(const std::shared_ptr<const TriangleMesh>& mesh, int threads, BuildCost& cost) {
  return std::make_unique<Bvh8Peer>(mesh, Bvh8Options{.threads = threads}, cost);
}

}  // namespace

std::vector<PeerKind> bvh8_peers() {
  return {{.name = "bvh8", .description = "ours, 8 wide, exact decisions", .build = build}};
}

}  // namespace plumb::bench

// The wide hierarchy, with the exact decisions that renders use, and with plain Moller-Trumbore in doubles in its
// leaves.
#include "renderer/accel/bvh8.h"

#include <optional>

#include "bench/peers/bvh8_plain.h"
#include "bench/peers/roster.h"

namespace plumb::bench {
namespace {

std::size_t bytes_of(const Bvh8& bvh, const TriangleMesh& mesh) {
  return bvh.bytes() + mesh.triangles.size() * sizeof(mesh.triangles[0]) + mesh.positions.size() * sizeof(Point3);
}

class ExactPeer : public PeerLoops<ExactPeer> {
 public:
  ExactPeer(const std::shared_ptr<const TriangleMesh>& mesh, int threads, BuildCost& cost) : mesh_(mesh) {
    timed_build(cost, [&] { bvh_.emplace(mesh, Bvh8Options{.threads = threads}); });
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
  std::size_t bytes() const override { return bytes_of(*bvh_, *mesh_); }

 private:
  std::shared_ptr<const TriangleMesh> mesh_;
  std::optional<Bvh8> bvh_;
};

class PlainPeer : public PeerLoops<PlainPeer> {
 public:
  PlainPeer(const std::shared_ptr<const TriangleMesh>& mesh, int threads, BuildCost& cost) : mesh_(mesh) {
    timed_build(cost, [&] { bvh_.emplace(mesh, Bvh8Options{.threads = threads}); });
  }

  Found closest_of(const RaySet& set, std::size_t ray) const override {
    return plain_closest(bvh_->tree(), set.rays[ray]);
  }
  bool any_of(const RaySet& set, std::size_t ray) const override { return plain_any(bvh_->tree(), set.rays[ray]); }
  std::size_t bytes() const override { return bytes_of(*bvh_, *mesh_); }

 private:
  std::shared_ptr<const TriangleMesh> mesh_;
  std::optional<Bvh8> bvh_;
};

template <class Made>
std::unique_ptr<Peer> build(const std::shared_ptr<const TriangleMesh>& mesh, int threads, BuildCost& cost) {
  return std::make_unique<Made>(mesh, threads, cost);
}

}  // namespace

std::vector<PeerKind> bvh8_peers() {
  return {{.name = "bvh8", .description = "ours, 8 wide, exact decisions", .build = build<ExactPeer>},
          {.name = "bvh8-plain",
           .description = "the same hierarchy, plain Moller-Trumbore in doubles",
           .build = build<PlainPeer>}};
}

}  // namespace plumb::bench

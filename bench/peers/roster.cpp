#include "bench/peers/roster.h"

#include <iterator>

namespace plumb::bench {

std::span<const PeerKind> peer_kinds() {
  static const std::vector<PeerKind> kinds = [] {
    std::vector<PeerKind> all = embree_peers();
#ifdef PLUMB_BENCH_BVH8
    std::ranges::move(bvh8_peers(), std::back_inserter(all));
#endif
    std::ranges::move(bvh2_peers(), std::back_inserter(all));
    std::ranges::move(cgal_peers(), std::back_inserter(all));
    return all;
  }();
  return kinds;
}

}  // namespace plumb::bench

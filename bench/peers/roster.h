#pragma once

#include <vector>

#include "bench/peers/peer.h"

namespace plumb::bench {

/// One file each: what it brings to the race, which may be several variants or, where a library is missing, none.
std::vector<PeerKind> embree_peers();
std::vector<PeerKind> bvh2_peers();
std::vector<PeerKind> bvh8_peers();
std::vector<PeerKind> cgal_peers();

}  // namespace plumb::bench

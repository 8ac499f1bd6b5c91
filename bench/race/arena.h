#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bench/peers/peer.h"

namespace plumb::bench {

/// How large a run is.
struct RaceSize {
  int rounds = 7;
  std::size_t rays = 131'072;
};

/// A contestant on one mesh.
struct Contestant {
  const PeerKind* kind;
  std::unique_ptr<Peer> peer;
};

/// A mesh, all contestants on it and its sets of rays, made when they are first asked for.
class Arena {
 public:
  explicit Arena(std::shared_ptr<const TriangleMesh> mesh);

  const TriangleMesh& mesh() const { return *mesh_; }
  const std::vector<Contestant>& contestants() const { return contestants_; }
  /// Throws std::out_of_range where no contestant has that name.
  const Peer& peer(std::string_view name) const;
  const RaySet& rays(std::string_view name, std::size_t count);

 private:
  std::shared_ptr<const TriangleMesh> mesh_;
  std::vector<Contestant> contestants_;
  std::map<std::string, RaySet, std::less<>> sets_;
};

/// The arena of a race's mesh. One is kept, that of the last name, so rows of a mesh belong together.
Arena& arena_of(const std::string& mesh);

/// The slice of the set that a contestant is asked: all, or most_rays of it, evenly spread.
Slice slice_for(const PeerKind& kind, const RaySet& set);

/// Asks what the set is for.
Tally ask(const Peer& peer, const RaySet& set, const Slice& slice);

/// Seconds of the thread's processor time a ray. Before, a few of the rays are asked untimed, so that what the others
/// left in the caches decides little.
double seconds_a_ray(const Contestant& contestant, const RaySet& set);

/// Rays of a contestant's slice by what is wrong with its answer.
struct Differences {
  /// Another decision whether something is hit, or a closest triangle that the ray does not meet, or meets farther away
  /// than the judge's. Another triangle at the same distance (a shared edge or vertex) is no difference.
  std::size_t all = 0;
  /// Of these: nothing is hit, or t is larger by a thousandth: the ray went through the surface. Of any-hit questions,
  /// a blocked ray that is not.
  std::size_t escapes = 0;
};
Differences differences(const Contestant& contestant, const Peer& judge, const RaySet& set, const TriangleMesh& mesh);

}  // namespace plumb::bench

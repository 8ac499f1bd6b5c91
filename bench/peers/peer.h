#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "bench/race/clocks.h"
#include "bench/race/ray_sets.h"
#include "meshes/triangle_mesh.h"

namespace plumb::bench {

/// The rays begin, begin + step, ... below end of a set.
struct Slice {
  std::size_t begin, end, step = 1;
  std::size_t count() const { return (end - begin + step - 1) / step; }
};

/// What a loop over rays found in all: so that no call can be left out by a compiler.
struct Tally {
  std::uint64_t hits = 0, triangles = 0;
};

/// A mesh that one of the contestants made ready. What it asks of rays is safe from several threads.
class Peer {
 public:
  virtual ~Peer() = default;
  /// Asks ray by ray, each in a call of its own. The rays are in the form that the peer takes; copying them into what a
  /// call wants is timed.
  virtual Tally closest(const RaySet& set, const Slice& slice) const = 0;
  virtual Tally any(const RaySet& set, const Slice& slice) const = 0;
  virtual Found closest_of(const RaySet& set, std::size_t ray) const = 0;
  virtual bool any_of(const RaySet& set, std::size_t ray) const = 0;
  /// Of positions, indices and hierarchy.
  virtual std::size_t bytes() const = 0;
};

/// The loops around closest_of() and any_of() of a class, with both inlined.
template <class Single>
class PeerLoops : public Peer {
 public:
  Tally closest(const RaySet& set, const Slice& slice) const final {
    Tally tally;
    for (std::size_t i = slice.begin; i < slice.end; i += slice.step) {
      const Found found = self().Single::closest_of(set, i);
      tally.hits += found.hit();
      tally.triangles += found.triangle;
    }
    return tally;
  }
  Tally any(const RaySet& set, const Slice& slice) const final {
    Tally tally;
    for (std::size_t i = slice.begin; i < slice.end; i += slice.step) tally.hits += self().Single::any_of(set, i);
    return tally;
  }

 private:
  const Single& self() const { return static_cast<const Single&>(*this); }
};

/// What a build takes: processor time of the whole process, and of the calling thread, which is its share of the work
/// and tells on a busy machine what wall time cannot; wall time.
struct BuildCost {
  double cpu = 0, caller = 0, wall = 0;
};

/// Runs `build`, and adds what it took.
template <class Build>
void timed_build(BuildCost& cost, const Build& build) {
  const double cpu = seconds_on(CLOCK_PROCESS_CPUTIME_ID), caller = seconds_on(CLOCK_THREAD_CPUTIME_ID);
  const double wall = seconds_on(CLOCK_MONOTONIC);
  build();
  cost.cpu += seconds_on(CLOCK_PROCESS_CPUTIME_ID) - cpu;
  cost.caller += seconds_on(CLOCK_THREAD_CPUTIME_ID) - caller;
  cost.wall += seconds_on(CLOCK_MONOTONIC) - wall;
}

struct PeerKind {
  std::string name;
  /// Version, instruction set, flags.
  std::string description;
  /// Ready to be asked. Adds the time from a mesh in memory, in the form that the peer takes, to the last of the
  /// hierarchy.
  std::unique_ptr<Peer> (*build)(const std::shared_ptr<const TriangleMesh>& mesh, int threads, BuildCost& cost);
  int most_threads = 2;  ///< that its build uses
  /// Beside rtcIntersect1M only; it is no single-ray call.
  bool batches = false;
  /// At most so many rays of a set, evenly spread; slow peers are asked few.
  std::size_t most_rays = ~std::size_t{0};
  std::size_t most_triangles = ~std::size_t{0};
};

/// All that were compiled in, Embree's default first.
std::span<const PeerKind> peer_kinds();
/// The exact peer by which the others' answers are judged.
inline constexpr std::string_view kJudge = "bvh2";

}  // namespace plumb::bench

#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "renderer/accel/accelerator.h"
#include "renderer/accel/bvh8.h"

namespace plumb {

/// The triangles of a mesh, ready to be searched by rays in the way that was asked for; nothing is built for the
/// others. All ways find the same hits, to the bit. Const and safe to use from any number of threads.
class TriangleSearch {
 public:
  /// `threads`, at least 1, may build.
  TriangleSearch(std::shared_ptr<const TriangleMesh> mesh, Accel accel, int threads = 1);

  /// The hit with the smallest exact t in the ray's closed range, of equal ones that of the lowest triangle. A ray with
  /// NaN, an infinite coordinate or no direction hits nothing, and nothing hits a triangle with such a vertex.
  std::optional<SurfaceHit> closest(const PlacedRay& ray, TraceCounters& counters) const;
  /// Whether there is one.
  bool any(const PlacedRay& ray, TraceCounters& counters) const;

  const TriangleMesh& mesh() const { return *mesh_; }

 private:
  /// One triangle after the other, or by the binary hierarchy.
  struct Boxes {
    Accelerator accelerator;
    double largest_coordinate;
  };
  using Search = std::variant<Boxes, Bvh8>;
  static Search make(const std::shared_ptr<const TriangleMesh>& mesh, Accel accel, int threads);

  std::shared_ptr<const TriangleMesh> mesh_;
  Search search_;
};

}  // namespace plumb

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "meshes/triangle_mesh.h"

namespace plumb {

/// Gives equal points of single precision one vertex. A table of indices with open addressing: it needs 8 to 16 bytes a
/// vertex, a quarter of what a map of points would.
class PointJoiner {
 public:
  /// Appends to `positions`, which must be empty and outlive it.
  explicit PointJoiner(std::vector<Point3>& positions) : positions_(positions), table_(kSmallest, kNone) {}

  /// The vertex at the point, a new one if there is none; 0 equals -0. The point must be finite.
  std::uint32_t vertex_at(std::array<float, 3> point);

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;
  static constexpr std::size_t kSmallest = 64;

  /// The place in the table that has the point's vertex, or the free one where it belongs.
  std::size_t place_of(const Point3& point) const;
  void grow();

  std::vector<Point3>& positions_;
  std::vector<std::uint32_t> table_;
};

}  // namespace plumb

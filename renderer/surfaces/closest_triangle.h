#pragma once

#include <cstdint>
#include <optional>

#include "renderer/surfaces/surface.h"
#include "renderer/surfaces/triangle.h"

namespace plumb {

/// The closest of the triangles of a mesh that a ray meets: by the exact t, equal ones by the lowest index. The way
/// the candidates are found, their order, and those that were offered twice change no bit of the result.
class ClosestTriangle {
 public:
  /// No coordinate of a vertex of the mesh is larger than `largest_coordinate`. Refers to both.
  ClosestTriangle(const PlacedRay& ray, const TriangleMesh& mesh, double largest_coordinate);

  /// Takes a triangle into account. Most that are missed cost a few nanoseconds.
  void offer(std::uint32_t triangle) {
    const auto& [a, b, c] = mesh_.triangles[triangle];
    offer(triangle, {mesh_.positions[a], mesh_.positions[b], mesh_.positions[c]});
  }

  /// The same of one whose corners are at hand. Its number is read only if it is met.
  void offer(const std::uint32_t& triangle, const TriangleVertices& corners) {
    const ShearedTriangle sheared(ray_, corners[0], corners[1], corners[2]);
    if (!sheared.is_missed(any_weight_error_)) consider(triangle, corners, sheared);
  }

  /// Whether the ray meets this triangle within its range; nothing is kept.
  bool meets(const TriangleVertices& corners) const;
  bool meets(std::uint32_t triangle) const { return meets(vertices(triangle)); }

  /// What lies strictly beyond cannot change the result. Not above the ray's own t_max nor its `nearest`.
  double t_max() const { return t_max_; }

  /// The closest within the ray's closed range of those offered.
  std::optional<SurfaceHit> result() const;

 private:
  void consider(const std::uint32_t& triangle, const TriangleVertices& corners, const ShearedTriangle& sheared);
  TriangleVertices vertices(std::uint32_t triangle) const;
  /// Whether this meeting lies before the best one, both in the range.
  bool is_nearer(const TriangleMeeting& meeting, std::uint32_t triangle, const TriangleVertices& corners) const;

  const TriangleMesh& mesh_;
  ShearedRay ray_;
  /// The error of any weight of any triangle of the mesh. Infinite where no bound holds.
  double any_weight_error_;
  double t_max_;
  const TriangleMeeting& best() const { return meetings_[best_]; }

  /// The best, whose t is the one to report, and room for the next: a copy would be slow.
  std::array<TriangleMeeting, 2> meetings_;
  std::size_t best_ = 0;
  std::uint32_t best_triangle_ = 0;
  bool found_ = false;
};

}  // namespace plumb

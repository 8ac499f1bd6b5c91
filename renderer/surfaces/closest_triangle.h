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
  ClosestTriangle(const PlacedRay& ray, const TriangleMesh& mesh, double largest_coordinate)
      : mesh_(mesh), ray_(ray), t_max_(std::min(ray.object().t_max, ray.nearest)) {
    const double m = 1.001 * (largest_coordinate + plumb::largest_coordinate(ray.object().origin));
    any_weight_error_ = plumb::any_weight_error(m, ray_.drift, ray_.drift_growth);
    const double along = std::fabs(coordinate(ray.object().direction, ray_.kz));
    has_ordinary_length_ = along >= 0x1p-200 && along <= 0x1p200;
  }

  /// Takes a triangle into account. Most that are missed cost a few nanoseconds.
  void offer(std::uint32_t triangle) {
    const auto& [a, b, c] = mesh_.triangles[triangle];
    offer(triangle, {mesh_.positions[a], mesh_.positions[b], mesh_.positions[c]});
  }

  /// The same of one whose corners are at hand. Its number, or what turns into it, is read only if it may be met.
  template <class Number>
  [[gnu::always_inline]] void offer(const Number& triangle, const TriangleVertices& corners) {
    const ShearedTriangle sheared(ray_, corners[0], corners[1], corners[2]);
    if (sheared.is_missed(any_weight_error_)) return;
    // Nearly all others are surely met, in range and nearer than the best, or surely not.
    TriangleMeeting& meeting = meetings_[1 - best_];
    if (is_plain(sheared, corners, meeting)) {
      const double low = meeting.t - meeting.t_error, high = meeting.t + meeting.t_error;
      if (low > t_max_ || high < ray_.ray.t_min) return;
      if (low > ray_.ray.t_min && high < t_max_ && (!found_ || high < best().t - best().t_error)) {
        keep(triangle);
        return;
      }
    }
    consider(triangle, corners, sheared);
  }

  /// Whether the ray meets this triangle within its range; nothing is kept.
  [[gnu::always_inline]] bool meets(const TriangleVertices& corners) const {
    const ShearedTriangle sheared(ray_, corners[0], corners[1], corners[2]);
    if (sheared.is_missed(any_weight_error_)) return false;
    TriangleMeeting meeting;
    if (is_plain(sheared, corners, meeting)) {
      const double low = meeting.t - meeting.t_error, high = meeting.t + meeting.t_error;
      if (low > ray_.ray.t_max || high < ray_.ray.t_min) return false;
      if (low > ray_.ray.t_min && high < ray_.ray.t_max) return true;
    }
    return surely_meets(sheared, corners);
  }
  bool meets(std::uint32_t triangle) const { return meets(vertices(triangle)); }

  /// What lies strictly beyond cannot change the result. Not above the ray's own t_max nor its `nearest`.
  double t_max() const { return t_max_; }

  /// The closest within the ray's closed range of those offered.
  std::optional<SurfaceHit> result() const;

 private:
  /// Whether doubles suffice to say that the ray's line meets the triangle, and about where.
  bool is_plain(const ShearedTriangle& sheared, const TriangleVertices& corners, TriangleMeeting& meeting) const {
    return sheared.is_sure_to_meet(any_weight_error_) && has_ordinary_length_ &&
           meet_plane(ray_, sheared.weights, corners[0], corners[1], corners[2], kSteepEnough, meeting);
  }
  void keep(std::uint32_t triangle) {
    best_ = 1 - best_;
    best_triangle_ = triangle;
    found_ = true;
    t_max_ = std::min(t_max_, best().t + best().t_error);
  }
  /// What the inline functions leave open.
  bool surely_meets(const ShearedTriangle& sheared, const TriangleVertices& corners) const;
  void consider(std::uint32_t triangle, const TriangleVertices& corners, const ShearedTriangle& sheared);
  TriangleVertices vertices(std::uint32_t triangle) const;
  SurfaceHit hit_of(const TriangleMeeting& meeting) const;
  /// Whether this meeting lies before the best one, both in the range.
  bool is_nearer(const TriangleMeeting& meeting, std::uint32_t triangle, const TriangleVertices& corners) const;

  const TriangleMesh& mesh_;
  ShearedRay ray_;
  /// The error of any weight of any triangle of the mesh. Infinite where no bound holds.
  double any_weight_error_;
  bool has_ordinary_length_;
  double t_max_;
  const TriangleMeeting& best() const { return meetings_[best_]; }

  /// The best, whose t is the one to report, and room for the next: a copy would be slow.
  std::array<TriangleMeeting, 2> meetings_;
  std::size_t best_ = 0;
  std::uint32_t best_triangle_ = 0;
  bool found_ = false;
};

}  // namespace plumb

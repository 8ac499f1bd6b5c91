#include "renderer/surfaces/closest_triangle.h"

#include <stdexcept>

namespace plumb {

TriangleVertices ClosestTriangle::vertices(std::uint32_t triangle) const {
  const auto& [a, b, c] = mesh_.triangles[triangle];
  return {mesh_.positions[a], mesh_.positions[b], mesh_.positions[c]};
}

bool ClosestTriangle::surely_meets(const ShearedTriangle& sheared, const TriangleVertices& corners) const {
  const auto& [a, b, c] = corners;
  TriangleMeeting meeting;
  return meet(ray_, sheared, a, b, c, meeting) && t_in_range(ray_, meeting, a, b, c);
}

bool ClosestTriangle::is_nearer(const TriangleMeeting& meeting, std::uint32_t triangle,
                                const TriangleVertices& corners) const {
  if (meeting.t + meeting.t_error < best().t - best().t_error) return true;  // rounding is monotone
  const ExactTriangle candidate(ray_.world, ray_.world_from_object, corners);
  const int order = candidate.compare_t({ray_.world, ray_.world_from_object, vertices(best_triangle_)});
  return order < 0 || (order == 0 && triangle < best_triangle_);
}

void ClosestTriangle::consider(std::uint32_t triangle, const TriangleVertices& corners,
                               const ShearedTriangle& sheared) {
  const auto& [a, b, c] = corners;
  TriangleMeeting& meeting = meetings_[1 - best_];
  if (!meet(ray_, sheared, a, b, c, meeting) || meeting.t - meeting.t_error > t_max_ ||
      (found_ && triangle == best_triangle_))
    return;
  const std::optional<double> t = t_in_range(ray_, meeting, a, b, c);
  if (!t) return;
  meeting.t = *t;
  if (found_ && !is_nearer(meeting, triangle, corners)) return;
  keep(triangle);
}

std::optional<SurfaceHit> ClosestTriangle::result() const {
  if (!found_) return std::nullopt;
  if (!best().is_rough) return hit_of(best());
  const auto [a, b, c] = vertices(best_triangle_);
  TriangleMeeting meeting;
  if (meet(ray_, ShearedTriangle(ray_, a, b, c), a, b, c, meeting)) {
    if (const std::optional<double> t = t_in_range(ray_, meeting, a, b, c)) {
      meeting.t = *t;
      return hit_of(meeting);
    }
  }
  throw std::logic_error("a triangle that a ray meets in its range is missed when looked at more closely");
}

SurfaceHit ClosestTriangle::hit_of(const TriangleMeeting& meeting) const {
  const TriangleHit hit = meeting.hit(meeting.t);
  return {hit.t, hit.u, hit.v, best_triangle_, meeting.t_error};
}

}  // namespace plumb

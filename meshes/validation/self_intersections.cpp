#include "meshes/validation/self_intersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <vector>

#include "meshes/validation/triangle_signs.h"

namespace plumb {
namespace {

/// Predicates on doubles, exact; nothing is constructed.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalPoint = Kernel::Point_3;

/// A box around a triangle, as CGAL's search wants it.
struct TriangleBox {
  using NT = double;
  using ID = std::uint32_t;
  static int dimension() { return 3; }
  double min_coord(int axis) const { return box.min[axis]; }
  double max_coord(int axis) const { return box.max[axis]; }
  ID id() const { return triangle; }

  Bounds3 box;
  std::uint32_t triangle;
};

using Places = std::array<std::uint32_t, 3>;

class Pairs {
 public:
  Pairs(const TriangleMesh& mesh, std::span<const std::uint32_t> place_of) : mesh_(mesh), place_of_(place_of) {}

  /// Of two triangles that have area.
  bool intersect(std::uint32_t first, std::uint32_t second) const {
    Places a = places(first), b = places(second);
    switch (move_shared_to_front(a, b)) {
      case 0:
        return !is_beside(a, b, 0) && !is_beside(b, a, 0) && CGAL::do_intersect(triangle(a), triangle(b));
      case 1:
        // What lies in both runs on from the shared vertex to where it leaves the first of the two: on the edge
        // opposite to the vertex.
        return !is_beside(a, b, 1) && !is_beside(b, a, 1) &&
               (CGAL::do_intersect(triangle(a), Kernel::Segment_3(point(b[1]), point(b[2]))) ||
                CGAL::do_intersect(triangle(b), Kernel::Segment_3(point(a[1]), point(a[2]))));
      case 2:
        return CGAL::orientation(point(a[0]), point(a[1]), point(a[2]), point(b[2])) == CGAL::COPLANAR &&
               CGAL::coplanar_orientation(point(a[0]), point(a[1]), point(a[2]), point(b[2])) == CGAL::POSITIVE;
      default:
        return true;
    }
  }

 private:
  Places places(std::uint32_t triangle) const {
    const auto& [a, b, c] = mesh_.triangles[triangle];
    return {place_of_[a], place_of_[b], place_of_[c]};
  }
  CgalPoint point(std::uint32_t place) const {
    const Point3& p = mesh_.positions[place];
    return {p.x, p.y, p.z};
  }
  Kernel::Triangle_3 triangle(const Places& p) const { return {point(p[0]), point(p[1]), point(p[2])}; }

  /// Returns how many places both have; they come first, in the same order.
  static std::size_t move_shared_to_front(Places& a, Places& b) {
    std::size_t shared = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto found = std::find(b.begin() + static_cast<std::ptrdiff_t>(shared), b.end(), a[i]);
      if (found == b.end()) continue;
      std::swap(a[shared], a[i]);
      std::swap(b[shared], *found);
      ++shared;
    }
    return shared;
  }

  /// Whether the places of b from `begin` on lie strictly on one side of the plane of a: most pairs end here.
  bool is_beside(const Places& a, const Places& b, std::size_t begin) const {
    const auto side = [&](std::size_t i) {
      return CGAL::orientation(point(a[0]), point(a[1]), point(a[2]), point(b[i]));
    };
    const CGAL::Orientation first = side(begin);
    if (first == CGAL::COPLANAR) return false;
    for (std::size_t i = begin + 1; i < 3; ++i)
      if (side(i) != first) return false;
    return true;
  }

  const TriangleMesh& mesh_;
  std::span<const std::uint32_t> place_of_;
};

std::vector<TriangleBox> boxes_of(const TriangleMesh& mesh) {
  std::vector<TriangleBox> boxes;
  boxes.reserve(mesh.triangles.size());
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const Point3 &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
    if (on_a_line(p, q, r)) continue;
    TriangleBox& added = boxes.emplace_back(TriangleBox{{}, i});
    for (const Point3* corner : {&p, &q, &r}) added.box.extend(*corner);
  }
  return boxes;
}

}  // namespace

MeshFault self_intersections(const TriangleMesh& mesh, std::span<const std::uint32_t> place_of,
                             const std::function<void(double)>& progress) {
  const std::vector<TriangleBox> boxes = boxes_of(mesh);
  std::vector<const TriangleBox*> pointers;
  pointers.reserve(boxes.size());
  for (const TriangleBox& box : boxes) pointers.push_back(&box);

  const Pairs pairs(mesh, place_of);
  std::vector<bool> met(mesh.triangles.size()), intersecting(mesh.triangles.size());
  // The search does not say how far it is, but at its end nearly every triangle has met its neighbours.
  std::size_t met_count = 0;
  const std::size_t step = boxes.size() / 256 + 1;
  CGAL::box_self_intersection_d(pointers.begin(), pointers.end(), [&](const TriangleBox* a, const TriangleBox* b) {
    for (const TriangleBox* box : {a, b}) {
      if (met[box->triangle]) continue;
      met[box->triangle] = true;
      if (++met_count % step == 0 && progress)
        progress(static_cast<double>(met_count) / static_cast<double>(boxes.size()));
    }
    if (intersecting[a->triangle] && intersecting[b->triangle]) return;
    if (pairs.intersect(a->triangle, b->triangle)) intersecting[a->triangle] = intersecting[b->triangle] = true;
  });

  MeshFault fault;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
    if (intersecting[i]) fault.add(i);
  return fault;
}

}  // namespace plumb

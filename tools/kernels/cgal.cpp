// CGAL's AABB_tree with exact constructions. AABB_tree is under the GPL, version 3 or later, as this project is.
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/version.h>

#include "tools/kernels/kernel_table.h"

namespace plumb::kernels {
namespace {

using Numbers = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Numbers::FT;
using Triangles = std::vector<Numbers::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Numbers, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Numbers, Primitive>>;

/// A hit whose numbers are exact fractions, not yet rounded.
struct ExactHit {
  Hit place;
  Number t, u, v;
};

bool is_nearer(const ExactHit& a, const ExactHit& b) {
  return a.t < b.t || (a.t == b.t && comes_before(a.place, b.place));
}

/// The tree says exactly which triangles the ray meets, and t, u and v are exact fractions until they are answered.
/// With inexact constructions the ray itself, which CGAL holds as two points, would be another one. first_intersection
/// is not asked: it gives points, not parameters, and the segments in which rays in a triangle's plane overlap it,
/// which are misses here.
class CgalKernel {
 public:
  explicit CgalKernel(std::span<const plumb_surface> surfaces) {
    for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
      const plumb_mesh& mesh = surfaces[s].mesh;
      for (std::uint32_t i = 0; i < mesh.triangle_count; ++i) add(mesh, s, i);
    }
    // Else a number known to five digits would be answered as it is.
    Number::set_relative_precision_of_to_double(0x1p-50);
    tree_.insert(triangles_.begin(), triangles_.end());
    tree_.build();
  }

  Hit closest(const Ray& ray) const {
    const std::vector<ExactHit> found = hits_of(ray);
    const auto first = std::ranges::min_element(found, is_nearer);
    return first == found.end() ? Hit{} : rounded(*first);
  }

  bool any(const Ray& ray) const { return !hits_of(ray).empty(); }

  void all(const Ray& ray, std::vector<Hit>& hits) const {
    for (const ExactHit& hit : hits_of(ray)) hits.push_back(rounded(hit));
  }

 private:
  void add(const plumb_mesh& mesh, std::uint32_t surface, std::uint32_t index) {
    const auto corner = [&](int k) {
      const double* p = mesh.positions + 3 * std::size_t{mesh.triangles[3 * std::size_t{index} + std::size_t(k)]};
      return Numbers::Point_3(p[0], p[1], p[2]);
    };
    const Numbers::Triangle_3 triangle(corner(0), corner(1), corner(2));
    if (triangle.is_degenerate()) return;  // the tree may not hold one; it is missed
    triangles_.push_back(triangle);
    places_.push_back({surface, index, 0, 0, 0});
  }

  std::vector<ExactHit> hits_of(const Ray& ray) const {
    const Numbers::Point_3 origin(ray.origin.x, ray.origin.y, ray.origin.z);
    const Numbers::Vector_3 direction(ray.direction.x, ray.direction.y, ray.direction.z);
    std::vector<Primitive::Id> ids;
    if (ray.t_min >= 0)
      tree_.all_intersected_primitives(Numbers::Ray_3(origin, direction), std::back_inserter(ids));
    else
      tree_.all_intersected_primitives(Numbers::Line_3(origin, direction), std::back_inserter(ids));
    std::vector<ExactHit> found;
    for (const Primitive::Id& id : ids) {
      const Numbers::Vector_3 edge1 = id->vertex(1) - id->vertex(0);
      const Numbers::Vector_3 edge2 = id->vertex(2) - id->vertex(0);
      const Numbers::Vector_3 p = CGAL::cross_product(direction, edge2);
      const Number determinant = edge1 * p;
      if (determinant == 0) continue;  // in the triangle's plane
      const Numbers::Vector_3 s = origin - id->vertex(0);
      const Numbers::Vector_3 q = CGAL::cross_product(s, edge1);
      const Number t = edge2 * q / determinant;
      if (!contains(ray, t)) continue;
      const auto place = static_cast<std::size_t>(id - triangles_.begin());
      found.push_back({places_[place], t, s * p / determinant, direction * q / determinant});
    }
    return found;
  }

  static bool contains(const Ray& ray, const Number& t) {
    return (std::isinf(ray.t_min) || t >= ray.t_min) && (std::isinf(ray.t_max) || t <= ray.t_max);
  }

  static Hit rounded(const ExactHit& exact) {
    Hit hit = exact.place;
    hit.t = CGAL::to_double(exact.t);
    hit.u = CGAL::to_double(exact.u);
    hit.v = CGAL::to_double(exact.v);
    return hit;
  }

  Triangles triangles_;
  std::vector<Hit> places_;
  Tree tree_;
};

constexpr plumb_contract kContract{
    .precision = PLUMB_DOUBLE,
    .t_precision = PLUMB_DOUBLE,
    .culling = PLUMB_CULL_NONE,
    .edge_rule = PLUMB_EDGE_CLOSED,
    .range = PLUMB_RANGE_CLOSED,
    .inside = PLUMB_INSIDE_HITS_EXIT,
    .shapes = PLUMB_MESHES,
    .capabilities = 0,  // its lazy numbers are shared and evaluated when they are asked for
    .largest = 0};

}  // namespace
}  // namespace plumb::kernels

PLUMB_KERNEL_EXPORT const plumb_kernel* plumb_kernel_v1() {
  using namespace plumb::kernels;
  static const plumb_kernel table = KernelTable<CgalKernel>::make(
      "cgal",
      "CGAL " CGAL_VERSION_STR
      " AABB_tree, exact predicates and exact constructions (Epeck), all_intersected_primitives and the least exact t",
      kContract);
  return &table;
}

// A third opinion, by code that is not ours: CGAL's exact kernel on whether a ray meets a triangle. It calls a coplanar
// overlap a hit where our rule says miss, and knows neither ranges nor degenerate triangles, so those are left out.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gtest/gtest.h>

#include "reference/triangle_cases_for_tests.h"
#include "reference/triangle_oracle.h"

namespace plumb {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

Kernel::Point_3 point(const Point3& p) { return {p.x, p.y, p.z}; }

TEST(TriangleAgainstEpeck, SaysTheSame) {
  TriangleCases cases(11);
  int compared = 0, hits = 0;
  for (const char* family : {"control", "edge", "vertex", "lattice", "lattice53", "grazing", "needle", "tiny", "far",
                             "huge", "zero", "surface"})
    for (int i = 0; i < 400; ++i) {
      TriangleCase c = cases.next(family);
      c.ray.t_min = 0;
      c.ray.t_max = std::numeric_limits<double>::infinity();
      const Kernel::Point_3 a = point(c.vertices[0]), b = point(c.vertices[1]), d = point(c.vertices[2]);
      const Kernel::Vector_3 direction(c.ray.direction.x, c.ray.direction.y, c.ray.direction.z);
      const Kernel::Vector_3 normal = CGAL::cross_product(b - a, d - a);
      if (CGAL::scalar_product(normal, direction) == 0) continue;
      const bool epeck = CGAL::do_intersect(Kernel::Ray_3(point(c.ray.origin), direction), Kernel::Triangle_3(a, b, d));
      StageCounters counters;
      const HitClass ours = decide_triangle(c.ray, c.vertices[0], c.vertices[1], c.vertices[2], counters).hit_class;
      ASSERT_EQ(ours != HitClass::miss, epeck) << family << " " << i;
      ++compared;
      hits += epeck;
    }
  EXPECT_GT(compared, 4000);
  EXPECT_GT(hits, 1500);
}

}  // namespace
}  // namespace plumb

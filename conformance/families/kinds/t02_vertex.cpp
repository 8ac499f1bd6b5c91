#include "conformance/families/triangles.h"

namespace plumb {
namespace {

FamilyCase vertex_case(Random& random, const Rounding& rounded) {
  const Vertices triangle = ordinary_triangle(random, rounded);
  std::vector<Ray> rays;
  while (rays.size() < kRaysPerCase) {
    const Point3 origin = facing_origin(random, triangle, 1, rounded);
    rays.push_back(ray_to(origin, triangle[random.below(3)], rounded));
  }
  return triangle_case(triangle, std::move(rays), rounded);
}

}  // namespace

extern const FamilyKind t02_vertex_kind{
    .id = "T2",
    .name = "vertex",
    .recipe = "d = rounded(P - o) with P a vertex of an ordinary triangle",
    .mistake = "none of the triangles around the vertex is hit, or several are",
    .make = [](std::uint64_t seed, plumb_precision precision) { return family_of("T2", vertex_case, seed, precision); },
};

}  // namespace plumb

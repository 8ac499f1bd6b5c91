#include "conformance/families/triangles.h"

namespace plumb {
namespace {

FamilyCase edge_case(Random& random, const Rounding& rounded) {
  const Vertices triangle = ordinary_triangle(random, rounded);
  std::vector<Ray> rays;
  while (rays.size() < kRaysPerCase) {
    const Point3 origin = facing_origin(random, triangle, 1, rounded);
    rays.push_back(ray_to(origin, edge_point(random, triangle), rounded));
  }
  return triangle_case(triangle, std::move(rays), rounded);
}

}  // namespace

extern const FamilyKind t01_edge_kind{
    .id = "T1",
    .name = "edge",
    .recipe = "d = rounded(P - o) with P on an edge of an ordinary triangle",
    .mistake = "both neighbours of the edge miss, or both hit",
    .make = [](std::uint64_t seed, plumb_precision precision) { return family_of("T1", edge_case, seed, precision); },
};

}  // namespace plumb

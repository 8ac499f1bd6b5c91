#include "conformance/families/solids.h"

namespace plumb {
namespace {

FamilyCase box_edge_case(Random& random, const Rounding& rounded) {
  const Shape box = ordinary_box(random, rounded);
  std::vector<Ray> rays;
  while (rays.size() < kRaysPerCase) {
    const bool inside = random.one_in(4);
    const Point3 origin = inside ? rounded(inner_point(random, box)) : outside_origin(random, box, rounded);
    rays.push_back(ray_to(origin, rim_point(random, box), rounded));
  }
  return case_of(box, std::move(rays));
}

}  // namespace

extern const FamilyKind b03_edges_kind{
    .id = "B3",
    .name = "box edges",
    .recipe = "d = rounded(P - o) with P on an edge or at a corner of a box, from outside and inside",
    .mistake = "a false miss, which in a hierarchy loses all that the box holds",
    .make = [](std::uint64_t seed,
               plumb_precision precision) { return family_of("B3", box_edge_case, seed, precision); },
};

}  // namespace plumb

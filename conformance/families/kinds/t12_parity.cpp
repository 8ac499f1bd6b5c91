#include <algorithm>

#include "conformance/families/aim.h"
#include "conformance/families/closed_meshes.h"

namespace plumb {
namespace {

/// Small ones, so that a case stays cheap.
std::vector<ClosedSurface> small_meshes(plumb_precision precision) {
  std::vector<ClosedSurface> list = closed_meshes(precision);
  std::erase_if(list, [](const ClosedSurface& closed) { return closed.surface.shape.mesh->triangles.size() > 100; });
  return list;
}

FamilyCase parity_case(Random& random, const Rounding& rounded) {
  static const std::vector<ClosedSurface> of_floats = small_meshes(PLUMB_FLOAT);
  static const std::vector<ClosedSurface> of_doubles = small_meshes(PLUMB_DOUBLE);
  const auto& list = rounded.is_float() ? of_floats : of_doubles;
  const Shape& shape = list[random.below(static_cast<std::uint32_t>(list.size()))].surface.shape;
  const TriangleMesh& mesh = *shape.mesh;
  const Point3 middle = middle_of(mesh);
  double size = 0;
  for (const Point3& p : mesh.positions) size = std::max(size, length(p - middle));
  std::vector<Ray> rays;
  while (rays.size() < kRaysPerCase) {
    const double distance = random.between(1.5, 4) * size;
    Point3 origin = rounded(middle + distance * random_direction(random));
    // Whole numbers, so that in the lattice cubes the way to a vertex or along an edge is exact.
    if (size > 8 && random.coin()) origin = {std::floor(origin.x), std::floor(origin.y), std::floor(origin.z)};
    rays.push_back(ray_to(origin, mesh_point(random, mesh), rounded));
  }
  return case_of(shape, std::move(rays));
}

}  // namespace

extern const FamilyKind t12_parity_kind{
    .id = "T12",
    .name = "parity",
    .recipe = "closed meshes from outside, through vertices, edges and faces, for all hits",
    .mistake = "a hit on an edge counts twice or not at all, so outside becomes inside",
    .make = [](std::uint64_t seed,
               plumb_precision precision) { return family_of("T12", parity_case, seed, precision); },
};

}  // namespace plumb

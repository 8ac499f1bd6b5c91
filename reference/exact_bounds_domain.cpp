#include "reference/exact_bounds_domain.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plumb {
namespace {

void require(bool condition, const char* message) {
  if (!condition) throw std::invalid_argument(message);
}

void require_finite(std::initializer_list<double> numbers) {
  require(std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); }),
          "the shape has a number that is not finite");
}

void require_round(const Shape& shape) {
  require(is_finite(shape.center), "the shape has a number that is not finite");
  require_finite({shape.radius});
  require(shape.radius >= 0, "the radius is negative");
  if (shape.kind == ShapeKind::sphere) return;
  require_finite({shape.height});
  require(shape.height >= 0, "the height is negative");
  if (shape.kind == ShapeKind::cylinder) return;
  require_finite({shape.tip_z});
  require(shape.center.z != shape.tip_z, "the cone's tip lies at its center");
}

void require_mesh(const TriangleMesh* mesh) {
  require(mesh != nullptr, "the mesh is absent");
  for (const auto& triangle : mesh->triangles)
    for (const std::uint32_t vertex : triangle) {
      require(vertex < mesh->positions.size(), "a triangle names a vertex that is not there");
      require(is_finite(mesh->positions[vertex]), "the mesh has a vertex that is not finite");
    }
}

}  // namespace

void require_bounded(const PlacedShape& placed) {
  for (const auto& row : placed.world_from_object)
    require(std::ranges::all_of(row, [](double x) { return std::isfinite(x); }),
            "the matrix has a number that is not finite");
  const Shape& shape = placed.shape;
  switch (shape.kind) {
    case ShapeKind::triangle:
      for (const Point3& vertex : shape.vertices) require_finite({vertex.x, vertex.y, vertex.z});
      return;
    case ShapeKind::box:
      require_finite({shape.min.x, shape.min.y, shape.min.z, shape.max.x, shape.max.y, shape.max.z});
      for (int axis = 0; axis < 3; ++axis) require(shape.min[axis] <= shape.max[axis], "the box has min > max");
      return;
    case ShapeKind::sphere:
    case ShapeKind::cylinder:
    case ShapeKind::cone:
      return require_round(shape);
    case ShapeKind::mesh:
      return require_mesh(shape.mesh.get());
  }
  require(false, "the shape's kind is unknown");
}

std::vector<Point3> used_vertices(const TriangleMesh& mesh) {
  std::vector<bool> used(mesh.positions.size(), false);
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t vertex : triangle) used[vertex] = true;
  std::vector<Point3> vertices;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i]) vertices.push_back(mesh.positions[i]);
  return vertices;
}

}  // namespace plumb

#include "conformance/families/closed_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "conformance/families/placed.h"
#include "meshes/generators/icosphere.h"

namespace plumb {
namespace {

/// The surface of `cuts` cubes a side, each with these edges, the corner with the smallest coordinates at `corner`.
TriangleMesh cube_mesh(int cuts, const Vec3& edges, const Vec3& corner) {
  TriangleMesh mesh;
  std::map<std::array<int, 3>, std::uint32_t> numbers;
  const auto vertex = [&](const std::array<int, 3>& place) {
    const auto [found, is_new] = numbers.try_emplace(place, static_cast<std::uint32_t>(mesh.positions.size()));
    if (is_new) {
      mesh.positions.push_back(
          {corner.x + place[0] * edges.x, corner.y + place[1] * edges.y, corner.z + place[2] * edges.z});
    }
    return found->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {0, cuts}) {
      for (int i = 0; i < cuts; ++i) {
        for (int j = 0; j < cuts; ++j) {
          const auto at = [&](int di, int dj) {
            std::array<int, 3> place{};
            place[axis] = side;
            place[(axis + 1) % 3] = i + di;
            place[(axis + 2) % 3] = j + dj;
            return vertex(place);
          };
          const std::uint32_t a = at(0, 0), b = at(1, 0), c = at(1, 1), d = at(0, 1);
          if (side == 0) {
            mesh.triangles.insert(mesh.triangles.end(), {{a, c, b}, {a, d, c}});
          } else {
            mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
          }
        }
      }
    }
  }
  return mesh;
}

TriangleMesh sphere_mesh(int subdivisions, double radius, const Vec3& center) {
  TriangleMesh mesh = icosphere(subdivisions);
  mesh.normals.clear();
  for (Point3& p : mesh.positions) p = to_point(center + radius * from_zero(p));
  return mesh;
}

/// Vertices moved in and out along their rays from the middle, by waves along the axes (Chebyshev polynomials).
TriangleMesh bumpy_mesh() {
  TriangleMesh mesh = sphere_mesh(3, 1, {});
  const auto wave = [](double x) { return (4 * x * x - 3) * x; };
  for (Point3& p : mesh.positions) p = to_point((1 + 0.3 * (wave(p.x) + wave(p.y) * wave(p.z))) * from_zero(p));
  return mesh;
}

ClosedSurface closed_mesh(std::string name, TriangleMesh mesh, const Rounding& rounded) {
  for (Point3& p : mesh.positions) p = rounded(p);
  ClosedSurface closed{std::move(name), {}};
  closed.surface.shape.kind = ShapeKind::mesh;
  closed.surface.shape.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
  return closed;
}

ClosedSurface closed_solid(std::string name, const Shape& solid) {
  ClosedSurface closed{std::move(name), {}};
  closed.surface.shape = solid;
  return closed;
}

struct NamedGroups {
  std::string_view name;
  Groups groups;
};

std::vector<NamedGroups> placements() {
  using enum TransformStep::Kind;
  Random random(1, "placements", 0);
  return {
      {"turned", {{{translate, {0.5, -2, 1}}, {rotate, {30, 40, 50}}}}},
      {"sheared", {{{scale, {4, 1, 1}}, {rotate, {0, 0, 30}}}, {{scale, {0.25, 1, 2}}, {rotate, {15, 0, 0}}}}},
      {"mirrored", {{{translate, {3, 1, -2}}, {scale, {-1, 1, 2}}, {rotate, {20, 0, 70}}}}},
      {"far", {{{translate, {4096, -12288, 8192}}, {rotate, {10, 20, 30}}, {scale, {1.5, 1, 0.75}}}}},
      {"nested", random_groups(random, 8, 6)},
  };
}

bool is_whole(const TriangleMesh& mesh) {
  for (const Point3& p : mesh.positions)
    for (int axis = 0; axis < 3; ++axis)
      if (p[axis] != std::floor(p[axis])) return false;
  return true;
}

Bounds3 box_around(const TriangleMesh& mesh) {
  Bounds3 box;
  for (const Point3& p : mesh.positions) box.extend(p);
  return box;
}

Point3 whole(const Point3& p) { return {std::floor(p.x), std::floor(p.y), std::floor(p.z)}; }

}  // namespace

std::vector<ClosedSurface> closed_meshes(plumb_precision precision) {
  const Rounding rounded(precision);
  std::vector<ClosedSurface> list;
  const auto add = [&](std::string name, TriangleMesh mesh) {
    list.push_back(closed_mesh(std::move(name), std::move(mesh), rounded));
  };
  add("icosphere-80", sphere_mesh(1, 1, {}));
  add("icosphere-320", sphere_mesh(2, 1, {}));
  add("icosphere-1280", sphere_mesh(3, 1, {}));
  add("cube-1", cube_mesh(1, {16, 16, 16}, {-8, -8, -8}));
  add("cube-2", cube_mesh(2, {8, 8, 8}, {-8, -8, -8}));
  add("cube-8", cube_mesh(8, {3, 3, 3}, {-5, -12, -20}));
  add("needle-box", cube_mesh(1, {4096, 1, 1}, {-2048, 0, 0}));
  add("cube-2-far-1e3", cube_mesh(2, {8, 8, 8}, {1000, -1000, 1000}));
  add("cube-4-far-1e5", cube_mesh(4, {8, 8, 8}, {-100000, 100000, 100000}));
  add("cube-4-far-1e7", cube_mesh(4, {32, 32, 32}, {10000000, -10000000, 10000000}));
  add("icosphere-80-far-1e3", sphere_mesh(1, 1, {1000, 1000, -1000}));
  add("icosphere-320-far-1e5", sphere_mesh(2, 100, {-100000, 100000, 100000}));
  add("icosphere-320-far-1e7", sphere_mesh(2, 10000, {10000000, 10000000, -10000000}));
  add("bumpy-1280", bumpy_mesh());
  return list;
}

std::vector<ClosedSurface> closed_solids(plumb_precision precision) {
  const Rounding rounded(precision);
  const Point3 place = rounded(Point3{0.1, -0.7, 1.3});
  return {
      closed_solid("sphere", sphere_of(place, rounded(0.9))),
      closed_solid("box", box_of(rounded(Point3{-1.1, -0.3, 0.2}), rounded(Point3{0.7, 0.9, 1.9}))),
      closed_solid("cylinder", cylinder_of(place, rounded(0.8), rounded(1.7))),
      closed_solid("cylinder-flat", cylinder_of(place, 1, 0.125)),
      closed_solid("cylinder-long", cylinder_of(place, rounded(0.3), 64)),
      closed_solid("cone", cone_of(place, rounded(0.6), rounded(1.4), rounded(2.3))),
      closed_solid("cone-steep", cone_of(place, rounded(0.8), 2, rounded(50.1))),
      closed_solid("cone-double", cone_of(place, rounded(0.4), rounded(2.2), rounded(1.7))),
  };
}

std::vector<ClosedSurface> under_matrices(const std::vector<ClosedSurface>& surfaces, plumb_precision precision) {
  const Rounding rounded(precision);
  std::vector<ClosedSurface> list;
  for (const NamedGroups& placement : placements()) {
    for (const ClosedSurface& closed : surfaces) {
      list.push_back(closed);
      list.back().name += "-" + std::string(placement.name);
      list.back().surface.groups = placement.groups;
      list.back().surface.world_from_object = rounded(product_of(placement.groups));
    }
  }
  return list;
}

Point3 middle_of(const TriangleMesh& mesh) { return box_around(mesh).center(); }

Point3 mesh_point(Random& random, const TriangleMesh& mesh) {
  const auto& face = mesh.triangles[random.below(static_cast<std::uint32_t>(mesh.triangles.size()))];
  const Vertices triangle{mesh.positions[face[0]], mesh.positions[face[1]], mesh.positions[face[2]]};
  switch (random.below(3)) {
    case 0:
      return triangle[random.below(3)];
    case 1:
      return edge_point(random, triangle);
    default:
      return inner_point(random, triangle);
  }
}

std::vector<Ray> leak_rays(const ClosedSurface& closed, std::uint64_t seed, std::size_t count,
                           plumb_precision precision) {
  const Rounding rounded(precision);
  const Shape& shape = closed.surface.shape;
  const TriangleMesh* mesh = shape.kind == ShapeKind::mesh ? shape.mesh.get() : nullptr;
  const Point3 middle = mesh ? middle_of(*mesh) : middle_of(shape);
  // Whole origins need room: seven tenths of the way out from the middle they are two units from the surface.
  const Vec3 extent = mesh ? box_around(*mesh).max - box_around(*mesh).min : Vec3{};
  const bool on_lattice = mesh && is_whole(*mesh) && std::min({extent.x, extent.y, extent.z}) >= 16;
  const AffineMatrix& matrix = closed.surface.world_from_object;
  std::vector<Ray> rays;
  for (std::uint64_t i = 0; rays.size() < count; ++i) {
    Random random(seed, closed.name, i);
    Point3 inside, target;
    if (mesh) {
      const double share = random.between(0, 0.7);
      inside = middle + share * (mesh_point(random, *mesh) - middle);
      if (on_lattice && random.coin()) inside = whole(inside);
      target = mesh_point(random, *mesh);
    } else {
      inside = inner_point(random, shape);
      target = random.one_in(3) ? surface_point(random, shape) : rim_point(random, shape);
    }
    rays.push_back(ray_to(rounded(mapped(matrix, inside)), mapped(matrix, target), rounded));
  }
  return rays;
}

}  // namespace plumb

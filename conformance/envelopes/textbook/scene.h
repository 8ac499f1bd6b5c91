#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

#include "conformance/envelopes/textbook/hierarchy.h"
#include "conformance/envelopes/textbook/matrix.h"
#include "conformance/envelopes/textbook/solids.h"

namespace plumb::textbook {

enum class Coat { lambertian, phong, glazed, glass };

/// What a surface looks like; white and matt at first.
template <class A>
struct Shader {
  Coat coat = Coat::lambertian;
  Vector<A> diffuse{1, 1, 1}, specular{1, 1, 1};
  RealOf<A> exponent = 1;
  RealOf<A> refractive_index = 1;
  /// Number of the shader below the glaze.
  std::size_t substrate = 0;
};

template <class A>
struct Light {
  Vector<A> position, intensity;
};

template <class A>
struct Camera {
  Vector<A> eye, to_center{0, 0, -1}, right{1, 0, 0}, up{0, 1, 0};
};

template <class A>
struct Mesh {
  std::vector<Vector<A>> positions, normals;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// One occurrence of a surface.
template <class A>
struct Placement {
  bool is_mesh = false;
  /// Number of the solid or mesh.
  std::size_t shape = 0;
  std::size_t shader = 0;
  /// From the world to the object, in the order in which they are applied: one matrix, or one for each transform, or
  /// none at all outside of any group.
  std::vector<Matrix<A>> object_from_world;
  Matrix<A> world_from_object;

  Ray<A> in_object(Ray<A> ray) const {
    for (const Matrix<A>& step : object_from_world)
      ray.origin = step.move(ray.origin), ray.direction = step.turn(ray.direction);
    return ray;
  }
  Vector<A> normal_in_world(Vector<A> normal) const {
    for (auto step = object_from_world.rbegin(); step != object_from_world.rend(); ++step)
      normal = step->turn_transposed(normal);
    return normal;
  }
};

template <class A>
struct Hit {
  using Real = RealOf<A>;
  Real t;
  std::uint32_t placement;
  /// Of a mesh the triangle, else the face.
  std::uint32_t part;
  /// Weights of the second and third vertex.
  Real u, v;
};

/// What is placed where, and a hierarchy over all of it: each solid and each triangle, in the world.
template <class A>
struct Scene {
  using Real = RealOf<A>;
  struct Primitive {
    std::uint32_t placement, triangle;
  };

  Formulas formulas = Formulas::usual;
  Camera<A> camera;
  std::vector<Light<A>> lights;
  std::vector<Shader<A>> shaders;
  std::vector<Solid<A>> solids;
  std::vector<Mesh<A>> meshes;
  /// In the order of the file, which decides ties.
  std::vector<Placement<A>> placements;
  std::vector<Primitive> primitives;
  Hierarchy<A> hierarchy;

  /// The hit with the smallest t; of equal ones the first in the file.
  std::optional<Hit<A>> closest(Ray<A> ray) const {
    std::optional<Hit<A>> best;
    search(ray, [&](const Hit<A>& hit) {
      const auto order = [](const Hit<A>& h) { return std::tuple(h.t, h.placement, h.part); };
      if (!best || order(hit) < order(*best)) best = hit;
      ray.t_max = best->t;
      return false;
    });
    return best;
  }

  bool blocks(Ray<A> ray) const {
    return search(ray, [](const Hit<A>&) { return true; });
  }

  /// Where a hit lies in the world. From the ray's t it would be off by the rounding of t, which in single precision
  /// leaves speckles where light grazes; put onto the surface, only by that of its own coordinates [Pharr 2016, 3.9].
  Vector<A> position(const Ray<A>& ray, const Hit<A>& hit) const {
    if (formulas == Formulas::other) return ray.at(hit.t);
    const Placement<A>& placed = placements[hit.placement];
    const Vector<A> local = placed.is_mesh ? mesh_point(meshes[placed.shape], hit)
                                           : snapped(solids[placed.shape], placed.in_object(ray).at(hit.t), hit.part);
    return placed.object_from_world.empty() ? local : placed.world_from_object.move(local);
  }

  /// In the world, of unit length.
  Vector<A> normal(const Ray<A>& ray, const Hit<A>& hit) const {
    const Placement<A>& placed = placements[hit.placement];
    const Vector<A> normal =
        placed.is_mesh ? mesh_normal(meshes[placed.shape], hit)
                       : solid_normal(solids[placed.shape], placed.in_object(ray), Crossing<A>{hit.t, hit.part});
    return unit(placed.normal_in_world(normal));
  }

 private:
  /// Offers hits in the range of `ray`, which `offer` may shorten, until it answers true.
  template <class Offer>
  bool search(const Ray<A>& ray, Offer&& offer) const {
    Ray<A> local = ray;
    const Placement<A>* frame = nullptr;
    return hierarchy.walk(ray, [&](std::uint32_t number) {
      const Primitive& primitive = primitives[number];
      const Placement<A>& placed = placements[primitive.placement];
      if (frame != &placed) local = placed.in_object(ray), frame = &placed;
      local.t_max = ray.t_max;
      const std::optional<Hit<A>> hit = meet(primitive, placed, local);
      return hit && offer(*hit);
    });
  }

  std::optional<Hit<A>> meet(const Primitive& primitive, const Placement<A>& placed, const Ray<A>& local) const {
    if (placed.is_mesh) {
      const Mesh<A>& mesh = meshes[placed.shape];
      const auto [a, b, c] = mesh.triangles[primitive.triangle];
      const auto at = meet_triangle(mesh.positions[a], mesh.positions[b], mesh.positions[c], local, formulas);
      if (!at) return std::nullopt;
      return Hit<A>{at->t, primitive.placement, primitive.triangle, at->u, at->v};
    }
    const auto at = meet_solid(solids[placed.shape], local, formulas);
    if (!at) return std::nullopt;
    return Hit<A>{at->t, primitive.placement, at->face, 0, 0};
  }

  Vector<A> mesh_point(const Mesh<A>& mesh, const Hit<A>& hit) const {
    const auto [a, b, c] = mesh.triangles[hit.part];
    const auto& p = mesh.positions;
    return p[a] + hit.u * (p[b] - p[a]) + hit.v * (p[c] - p[a]);
  }

  Vector<A> mesh_normal(const Mesh<A>& mesh, const Hit<A>& hit) const {
    const auto [a, b, c] = mesh.triangles[hit.part];
    if (mesh.normals.empty()) {
      const auto& p = mesh.positions;
      return cross(p[b] - p[a], p[c] - p[a]);
    }
    const auto& n = mesh.normals;
    if (formulas == Formulas::other) return n[a] + hit.u * (n[b] - n[a]) + hit.v * (n[c] - n[a]);
    return (1 - hit.u - hit.v) * n[a] + hit.u * n[b] + hit.v * n[c];
  }
};

}  // namespace plumb::textbook

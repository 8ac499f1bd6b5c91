#pragma once

#include <array>
#include <memory>

#include "meshes/triangle_mesh.h"
#include "renderer/math/transform.h"
#include "renderer/math/vec3.h"

namespace plumb {

/// What the oracle knows.
enum class ShapeKind { triangle, sphere, box, cylinder, cone, mesh };

/// A surface in its own frame (object space), all numbers exact as they stand. What a kind does not use is ignored.
/// Solids (all but triangle and mesh) are closed sets, capped; their surface is what a ray hits, from both sides.
/// A shape with a number that is not finite, a negative radius or height, a box with min > max or a cone with
/// center.z == tip_z is outside of the oracle's domain: it answers `unsupported`.
struct Shape {
  ShapeKind kind = ShapeKind::triangle;
  /// triangle
  std::array<Point3, 3> vertices{};
  /// sphere, cylinder, cone. The cylinder's and the cone's axis runs along z through it, at half of the height.
  Point3 center{};
  double radius = 1;
  double height = 1;
  /// cone: where x^2 + y^2 (about the axis) <= (radius / (center.z - tip_z))^2 (z - tip_z)^2 and |z - center.z| <=
  /// height / 2, with the quotient taken exactly. With the tip inside, both nappes belong to it.
  double tip_z = 0;
  /// box
  Point3 min{};
  Point3 max{};
  /// mesh: the surface that its triangles make, not a solid.
  std::shared_ptr<const TriangleMesh> mesh{};
};

/// A shape under an affine map whose doubles are exact.
struct PlacedShape {
  Shape shape;
  AffineMatrix world_from_object = identity_matrix();
};

}  // namespace plumb

#pragma once

#include <array>
#include <cstdint>

#include "renderer/accel/mapped_array.h"
#include "renderer/math/vec3.h"

namespace plumb {

/// Up to eight boxes: four cache lines, of which the first three hold the sides, by axis and then low and high.
struct alignas(64) Bvh8Node {
  std::array<std::array<std::array<float, 8>, 2>, 3> sides;
  /// The number of the first child among the nodes, and among the leaves where child 0 would be if all were leaves. The children that are
  /// nodes come first; both kinds lie side by side.
  std::uint32_t first_node;
  std::uint32_t first_leaf;
  std::uint8_t nodes;
  /// A bit for each child that there is.
  std::uint8_t present;
};
static_assert(sizeof(Bvh8Node) == 256);

/// Up to eight triangles that share up to eight vertices: two cache lines.
struct alignas(64) Bvh8Leaf {
  /// The coordinates of the vertices, by axis, in the frame of the filter.
  std::array<std::array<float, 8>, 3> vertices;
  /// corner[k][i] is the vertex at corner k of triangle i.
  std::array<std::array<std::uint8_t, 8>, 3> corner;
  /// Where the numbers of the triangles begin in Bvh8Tree::triangles.
  std::uint32_t first;
  /// A bit for each triangle that there is.
  std::uint8_t present;
};
static_assert(sizeof(Bvh8Leaf) == 128);

/// What takes the mesh's coordinates to those of the leaves and boxes, floats of moderate size: (p - center) * factor, the factor a
/// power of two. Wherever the mesh's numbers are floats of moderate size already it is the identity.
struct FilterFrame {
  Point3 center;
  double factor = 1;
  /// In the frame: the largest coordinate of a vertex, and how far a float vertex may be from the true one on an axis.
  double reach = 0;
  double vertex_error = 0;
  /// Of a ray that is exact in floats: what its boxes are widened by, and the bounds of FilterRay.
  float margin = 0, weight_error = 0, weight_error_constant = 0;

  Point3 operator()(const Point3& p) const {
    return {(p.x - center.x) * factor, (p.y - center.y) * factor, (p.z - center.z) * factor};
  }
};

/// A hierarchy as it is walked. Node 0 is the root; empty if there is none.
struct Bvh8Tree {
  MappedArray<Bvh8Node> nodes;
  MappedArray<Bvh8Leaf> leaves;
  /// The mesh's number of each triangle of each leaf; a triangle may occur in several leaves.
  MappedArray<std::uint32_t> triangles;
  FilterFrame frame;
  /// Whether the vertices of the leaves are the mesh's own, to the bit.
  bool exact_vertices = false;
};

/// The longest path from the root to a leaf that the builder makes, and so what a walk must be able to put aside.
constexpr int kBvh8Deepest = 96;

}  // namespace plumb

#pragma once

#include <array>
#include <cstdint>

#include "renderer/accel/mapped_array.h"
#include "renderer/math/vec3.h"

namespace plumb {

/// Up to eight boxes, each as whole steps from the corner `origin`, after [Ylitie 2017]: a coordinate of box i on axis a is
/// origin[a] + step[a] * steps[a][0][i] for the low side, steps[a][1][i] for the high one. The boxes hold what they must, rounded outward.
/// Two cache lines, wherever it lies in an array.
struct alignas(32) Bvh8Node {
  std::array<float, 3> origin;
  /// Powers of two.
  std::array<float, 3> step;
  std::array<std::array<std::array<std::uint8_t, 8>, 2>, 3> steps;
  /// The children are nodes first, then leaves; each lie side by side in their array. `first_leaf` is where child 0 would be.
  std::uint32_t first_node;
  std::uint32_t first_leaf;
  std::uint8_t nodes;
  /// A bit for each child that there is.
  std::uint8_t present;
};
static_assert(sizeof(Bvh8Node) == 96);

/// What a walk remembers of a child: the index of a node, or that of a leaf with this bit.
constexpr std::uint32_t kBvh8Leaf = 0x80000000;

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

/// A hierarchy as it is walked. Node 0 is the root; empty if there are no nodes.
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

#pragma once

#include <array>
#include <cstdint>

#include "renderer/accel/mapped_array.h"
#include "renderer/math/vec3.h"

namespace plumb {

/// Up to eight boxes, each as whole steps from the corner `origin`, after [Ylitie 2017] with 16 bits: a coordinate of box i on axis a is
/// origin[a] + step[a] * steps[a][0][i] for the low side, steps[a][1][i] for the high one. The boxes hold what they must, rounded outward.
struct alignas(64) Bvh8Node {
  std::array<float, 3> origin;
  /// Powers of two.
  std::array<float, 3> step;
  std::array<std::array<std::array<std::uint16_t, 8>, 2>, 3> steps;
  /// The block of the first child; the others follow it, nodes first, then leaves.
  std::uint32_t first;
  std::uint8_t nodes;
  /// A bit for each child that there is.
  std::uint8_t present;
};
static_assert(sizeof(Bvh8Node) == 128);

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

/// Nodes and leaves lie in one array, so that a child is found the same way whichever it is.
union Bvh8Block {
  Bvh8Node node;
  Bvh8Leaf leaf;
};

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

/// A hierarchy as it is walked. Block 0 is the root, a node; empty if there is none.
struct Bvh8Tree {
  MappedArray<Bvh8Block> blocks;
  /// The mesh's number of each triangle of each leaf; a triangle may occur in several leaves.
  MappedArray<std::uint32_t> triangles;
  FilterFrame frame;
  /// Whether the vertices of the leaves are the mesh's own, to the bit.
  bool exact_vertices = false;
};

/// The longest path from the root to a leaf that the builder makes, and so what a walk must be able to put aside.
constexpr int kBvh8Deepest = 96;

}  // namespace plumb

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "renderer/accel/mapped_array.h"
#include "renderer/accel/triangle_numbers.h"
#include "renderer/math/vec3.h"

namespace plumb {

/// Where a node or leaf begins in Bvh8Tree::lines, in cache lines, times two, and one more if it is a leaf.
using Bvh8Reference = std::uint32_t;

/// Up to eight boxes: four cache lines, of which the first three hold the sides, by axis and then low and high. A box
/// that is not there is empty, its low sides infinite and its high ones minus infinity.
struct alignas(64) Bvh8Node {
  std::array<std::array<std::array<float, 8>, 2>, 3> sides;
  std::array<Bvh8Reference, 8> child;
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

/// What takes the mesh's coordinates to those of the leaves and boxes, floats of moderate size: (p - center) * factor,
/// the factor a power of two. Wherever the mesh's numbers are floats of moderate size already it is the identity.
struct FilterFrame {
  Point3 center;
  double factor = 1;
  /// In the frame: the largest coordinate of a vertex, and how far a float vertex may be from the true one on an axis.
  double reach = 0;
  double vertex_error = 0;
  /// Of a ray that is exact in floats: what its boxes are widened by, and the bounds of FilterRay.
  float margin = 0, weight_error = 0, weight_error_constant = 0, distance_error = 0;
  /// No coordinate of an origin that counts as near is larger.
  float near = 0;
  bool is_identity = true;
  /// False where the mesh is so large or small that a frame of it has no doubles.
  bool is_usable = true;

  Point3 operator()(const Point3& p) const {
    return {(p.x - center.x) * factor, (p.y - center.y) * factor, (p.z - center.z) * factor};
  }
};

struct alignas(64) CacheLine {
  std::array<std::byte, 64> bytes;
};

/// A hierarchy as it is walked. The root is a node, at the first line; empty if there is none.
struct Bvh8Tree {
  MappedArray<CacheLine> lines;
  /// The mesh's number of each triangle of each leaf; a triangle may occur in several leaves.
  TriangleNumbers triangles;
  FilterFrame frame;
  /// Whether the vertices of the leaves are the mesh's own, to the bit.
  bool exact_vertices = false;
};

/// The longest path from the root to a leaf that the builder makes, and so what a walk must be able to put aside.
constexpr int kBvh8Deepest = 96;

}  // namespace plumb

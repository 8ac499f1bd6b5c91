#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "meshes/triangle_mesh.h"
#include "renderer/accel/float4.h"
#include "renderer/accel/mapped_array.h"

namespace plumb {

/// A triangle, or the part of one, as the builder sees it: 32 bytes, the number being the bits of the fourth lane of `box.low`.
struct TriangleBox {
  FloatBox box;

  std::uint32_t triangle() const { return std::bit_cast<std::uint32_t>(static_cast<float>(box.low[3])); }
  void set_triangle(std::uint32_t triangle) { box.low[3] = std::bit_cast<float>(triangle); }
};

/// A node of the binary tree that an 8-wide one is gathered from. Its children stand side by side at `first`; a leaf's triangles are
/// `count` from `first` in the order that the build leaves behind.
struct BinaryNode {
  FloatBox box;
  std::uint32_t first;
  std::uint32_t count;  // 0: has children
  /// The least areas that the wide nodes below take together, if this node's subtree may fill n children of a wide node above it: cost[n - 1],
  /// for 1 to 8, where the last is of its own children without itself [Ylitie 2017].
  std::array<float, 8> cost;
  /// How many of n children the first child fills then, at n - 1; 0: the node is one child, whatever there is room for.
  std::array<std::uint8_t, 8> split;
};

/// What a leaf may hold.
constexpr std::uint32_t kLeafTriangles = 8;
constexpr std::uint32_t kLeafVertices = 8;

/// Builds top down by the surface area heuristic over bins [Wald 2007] until what is left fits a leaf, and reorders `boxes` so that leaves are runs of
/// it. Node 0 is the root; `boxes` is not empty. No path is longer than kBvh8Deepest.
MappedArray<BinaryNode> build_binary_tree(const TriangleMesh& mesh, std::span<TriangleBox> boxes, int threads);

/// How many vertices the triangles have together, but at most `most` + 1.
std::uint32_t count_vertices(const TriangleMesh& mesh, std::span<const TriangleBox> triangles, std::uint32_t most);

}  // namespace plumb

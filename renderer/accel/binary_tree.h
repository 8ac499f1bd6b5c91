#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "meshes/triangle_mesh.h"
#include "renderer/accel/float4.h"
#include "renderer/accel/mapped_array.h"

namespace plumb {

/// Triangles that stay together, as the builder sees them: 32 bytes, the fourth lanes of the box' sides holding bits of
/// other numbers. They are `count` from `first` in a list of triangles.
struct TriangleGroup {
  FloatBox box;

  std::uint32_t first() const { return std::bit_cast<std::uint32_t>(static_cast<float>(box.low[3])); }
  std::uint32_t count() const { return std::bit_cast<std::uint32_t>(static_cast<float>(box.high[3])); }
  void set(const FloatBox& around, std::uint32_t first, std::uint32_t count) {
    box = around;
    box.low[3] = std::bit_cast<float>(first);
    box.high[3] = std::bit_cast<float>(count);
  }
};

/// A node of the binary tree that an 8-wide one is gathered from. Its children stand side by side at `first`; a leaf's
/// groups are `count` from `first` in the order that the build leaves behind.
struct BinaryNode {
  FloatBox box;
  std::uint32_t first;
  std::uint32_t count;  // 0: has children
  /// The least areas that the wide nodes below take together, if this node's subtree may fill n children of a wide node
  /// above it: cost[n - 1], for 1 to 8, where the last is of its own children without itself [Ylitie 2017].
  std::array<float, 8> cost;
  /// How many of n children the first child fills then, at n - 1; 0: the node is one child, whatever there is room for.
  std::array<std::uint8_t, 8> split;
};

/// What a leaf may hold.
constexpr std::uint32_t kLeafTriangles = 8;
constexpr std::uint32_t kLeafVertices = 8;

/// A mesh and the list of its triangles that groups refer to.
struct ListedTriangles {
  const TriangleMesh& mesh;
  std::span<const std::uint32_t> triangles;
};

/// Builds top down by the surface area heuristic over bins [Wald 2007] until what is left fits a leaf, and reorders
/// `groups` so that leaves are runs of it. Node 0 is the root; `groups` is not empty. No path is longer than
/// kBvh8Deepest.
MappedArray<BinaryNode> build_binary_tree(const ListedTriangles& listed, std::span<TriangleGroup> groups, int threads);

}  // namespace plumb

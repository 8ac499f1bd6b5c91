#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "meshes/triangle_mesh.h"
#include "renderer/accel/float4.h"
#include "renderer/accel/mapped_array.h"
#include "renderer/accel/triangle_group.h"
#include "renderer/accel/worker_pool.h"

namespace plumb {

/// What a leaf may hold.
constexpr std::uint32_t kLeafTriangles = 8;
constexpr std::uint32_t kLeafVertices = 8;

/// A node of the binary tree that an 8-wide one is gathered from. Its children stand side by side at `first`; a leaf's
/// groups are `count` from `first` in the order that the build leaves behind.
struct BinaryNode {
  /// Of a node with children.
  struct Inner {
    /// The least areas that the wide nodes below take together, if this node's subtree may fill n children of a wide
    /// node above it: cost[n - 1], for 1 to 8, where the last is of its own children without itself [Ylitie 2017].
    std::array<float, 8> cost;
    /// How many of n children the first child fills then, at n - 1; 0: the node is one child, whatever there is room
    /// for.
    std::array<std::uint8_t, 8> split;
    std::uint32_t groups;  ///< below it
  };
  /// Of a leaf.
  struct Leaf {
    std::array<std::uint32_t, kLeafVertices> vertices;
    /// corner[k][i] is the place among them of corner k of triangle i.
    std::array<std::array<std::uint8_t, kLeafTriangles>, 3> corner;
    std::uint8_t vertex_count, triangle_count;
  };

  FloatBox box;
  std::uint32_t first;
  std::uint32_t count;  ///< 0: has children
  union {
    Inner inner;
    Leaf leaf;
  };

  bool is_leaf() const { return count > 0; }
  /// As Inner says of nodes with children; a leaf adds no wide node.
  float cost(std::size_t room) const { return is_leaf() ? 0 : inner.cost[room - 1]; }
  std::uint32_t split(std::size_t room) const { return is_leaf() ? 0 : inner.split[room - 1]; }
};

/// A mesh and the list of its triangles that groups refer to.
struct ListedTriangles {
  const TriangleMesh& mesh;
  std::span<const std::uint32_t> triangles;  ///< empty: all of the mesh's in order
  std::uint32_t operator[](std::uint32_t i) const { return triangles.empty() ? i : triangles[i]; }
};

/// Builds top down by split_groups until what is left fits a leaf, and reorders `groups`, all of which are `all`, so
/// that leaves are runs of it. Node 0 is the root; `groups` is not empty. No path is longer than kBvh8Deepest. The tree
/// and the order of the groups are the same whatever the number of threads; where nodes stand is not.
MappedArray<BinaryNode> build_binary_tree(const ListedTriangles& listed, std::span<TriangleGroup> groups,
                                          const GroupRange& all, WorkerPool& pool);

}  // namespace plumb

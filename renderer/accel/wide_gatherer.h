#pragma once

#include <span>

#include "renderer/accel/binary_tree.h"
#include "renderer/accel/bvh8_layout.h"
#include "renderer/accel/frame_vertices.h"
#include "renderer/accel/worker_pool.h"

namespace plumb {

/// What an 8-wide hierarchy is gathered from: a binary tree and what its leaves refer to.
struct BinaryTree {
  const ListedTriangles& listed;
  const FrameVertices& vertices;
  std::span<const TriangleGroup> groups;
  std::span<const BinaryNode> nodes;
};

/// Puts the nodes and leaves into `tree`, the children of a node side by side. Their places depend on the binary tree
/// alone, not on the number of threads.
void gather_wide(const BinaryTree& binary, Bvh8Tree& tree, WorkerPool& pool);

}  // namespace plumb

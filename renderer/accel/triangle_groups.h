#pragma once

#include <cstdint>
#include <span>

#include "meshes/triangle_mesh.h"
#include "renderer/accel/binary_tree.h"
#include "renderer/accel/frame_vertices.h"
#include "renderer/accel/mapped_array.h"
#include "renderer/accel/triangle_group.h"
#include "renderer/accel/worker_pool.h"

namespace plumb {

/// What a hierarchy is built over.
struct TriangleGroups {
  MappedArray<std::uint32_t> triangles;  ///< that groups refer to; empty where they refer to the mesh's own
  MappedArray<TriangleGroup> groups;
  GroupRange all;  ///< of all groups
  std::span<const std::uint32_t> listed() const { return {triangles.data(), triangles.size()}; }
};

/// Each triangle is a group, but for those of parts of the mesh that have no more vertices than a leaf: a part is cut
/// into as few groups as fit leaves, since its triangles have about the same box where it is long and thin. Triangles
/// with a vertex that is not finite are left out.
TriangleGroups group_triangles(const TriangleMesh& mesh, const FrameVertices& vertices, WorkerPool& pool);

}  // namespace plumb

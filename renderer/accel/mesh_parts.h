#pragma once

#include <cstdint>

#include "meshes/triangle_mesh.h"
#include "renderer/accel/mapped_array.h"
#include "renderer/accel/worker_pool.h"

namespace plumb {

/// The parts of a mesh: sets of vertices that triangles join. They are the same whatever the number of threads.
class MeshParts {
 public:
  MeshParts(const TriangleMesh& mesh, WorkerPool& pool);

  /// The lowest vertex of the part that a vertex is of.
  std::uint32_t of(std::uint32_t vertex) const;
  /// Whether the part has at least three vertices, and no more than a leaf.
  bool is_small(std::uint32_t part) const;
  bool has_small() const { return has_small_; }

 private:
  void join(std::uint32_t a, std::uint32_t b);
  std::uint32_t root_of(std::uint32_t vertex);
  void count(std::uint32_t vertex);

  MappedArray<std::uint32_t> parent_;    // a root's is itself; no vertex's is higher than the vertex
  MappedArray<std::uint32_t> vertices_;  // of each root's part, exact up to what a leaf has
  bool has_small_ = false;
};

}  // namespace plumb

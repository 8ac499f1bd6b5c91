#pragma once

#include <cstdint>

#include "meshes/triangle_mesh.h"
#include "renderer/accel/bvh8_layout.h"
#include "renderer/accel/float4.h"
#include "renderer/accel/mapped_array.h"
#include "renderer/accel/worker_pool.h"

namespace plumb {

/// The frame in which the vertices of a mesh are floats of moderate size, but for its vertex_error and the filters'
/// bounds. Vertices that are not finite count for nothing.
FilterFrame frame_of(const TriangleMesh& mesh, WorkerPool& pool);

/// The vertices in a frame, in floats. Tells the frame how far rounding moved one on an axis at most.
class FrameVertices {
 public:
  FrameVertices(const TriangleMesh& mesh, FilterFrame& frame, WorkerPool& pool);
  BoxSide operator[](std::uint32_t i) const { return vertices_[i]; }

 private:
  MappedArray<BoxSide> vertices_;
};

}  // namespace plumb

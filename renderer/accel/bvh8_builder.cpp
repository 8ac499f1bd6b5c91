#include "renderer/accel/bvh8_builder.h"

#include <span>

#include "renderer/accel/binary_tree.h"
#include "renderer/accel/filter_ray.h"
#include "renderer/accel/frame_vertices.h"
#include "renderer/accel/triangle_groups.h"
#include "renderer/accel/wide_gatherer.h"
#include "renderer/accel/worker_pool.h"

namespace plumb {

Bvh8Tree build_bvh8(const TriangleMesh& mesh, const Bvh8Options& options) {
  constexpr std::size_t kWorthThreads = 2048;
  WorkerPool pool(mesh.triangles.size() < kWorthThreads ? 1 : options.threads);
  Bvh8Tree tree;
  tree.frame = frame_of(mesh, pool);
  const FrameVertices vertices(mesh, tree.frame, pool);
  set_filter_errors(tree.frame);
  tree.exact_vertices = tree.frame.vertex_error == 0 && tree.frame.factor == 1 && tree.frame.center == Point3{};
  if (!tree.frame.is_usable) return tree;
  TriangleGroups groups = group_triangles(mesh, vertices, pool);
  if (groups.groups.size() == 0) return tree;
  const ListedTriangles listed{mesh, groups.listed()};
  const std::span<TriangleGroup> all(groups.groups.data(), groups.groups.size());
  const MappedArray<BinaryNode> nodes = build_binary_tree(listed, all, groups.all, pool);
  gather_wide({listed, vertices, all, {nodes.data(), nodes.size()}}, tree, pool);
  return tree;
}

}  // namespace plumb

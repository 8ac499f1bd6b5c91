#include "meshes/editing/loop_subdivide.h"

#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <algorithm>
#include <stdexcept>

#include "meshes/editing/half_edge_mesh.h"

namespace plumb {
namespace {

/// Its table of weights ends at 50 neighbours unless told otherwise, without a check.
class Loop : public OpenMesh::Subdivider::Uniform::LoopT<HalfEdgeMesh> {
 public:
  explicit Loop(const HalfEdgeMesh& mesh) {
    std::size_t most = 0;
    for (const auto v : mesh.vertices()) most = std::max<std::size_t>(most, v.valence());
    init_weights(most + 1);
  }
};

TexCoord middle(const TexCoord& a, const TexCoord& b) { return {a.u / 2 + b.u / 2, a.v / 2 + b.v / 2}; }

}  // namespace

TriangleMesh loop_subdivided(const TriangleMesh& mesh) {
  // Six half-edges for each of four times as many triangles.
  if (mesh.triangles.size() > 0x7fffffff / 24)
    throw std::length_error("loop_subdivided: more triangles than OpenMesh counts");
  HalfEdgeMesh half_edges = half_edge_mesh(mesh);
  TriangleMesh finer;
  finer.texcoords = mesh.texcoords;
  if (!mesh.texcoords.empty()) {
    // Edge by edge, as OpenMesh makes the new vertices.
    for (const auto e : half_edges.edges())
      finer.texcoords.push_back(middle(mesh.texcoords[static_cast<std::size_t>(e.v0().idx())],
                                       mesh.texcoords[static_cast<std::size_t>(e.v1().idx())]));
  }
  Loop loop(half_edges);
  loop(half_edges, 1);
  finer.positions.reserve(half_edges.n_vertices());
  for (const auto v : half_edges.vertices()) {
    const auto& p = half_edges.point(v);
    // OpenMesh leaves a vertex of no triangle at a place that it never set.
    finer.positions.push_back(half_edges.is_isolated(v) ? mesh.positions[static_cast<std::size_t>(v.idx())]
                                                        : Point3{p[0], p[1], p[2]});
  }
  finer.triangles.reserve(half_edges.n_faces());
  for (const auto f : half_edges.faces()) {
    std::array<std::uint32_t, 3> triangle{};
    std::size_t corner = 0;
    for (const auto v : f.vertices()) triangle[corner++] = static_cast<std::uint32_t>(v.idx());
    finer.triangles.push_back(triangle);
  }
  return finer;
}

}  // namespace plumb

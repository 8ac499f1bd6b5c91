#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "meshes/triangle_mesh.h"

namespace plumb {

struct HalfEdgeTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};

/// For the .cpp files of this folder alone: their own headers show no type of OpenMesh.
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<HalfEdgeTraits>;

/// The places and triangles of a mesh, under the same numbers. Throws std::invalid_argument for a mesh with a
/// manifold_fault, which OpenMesh would change without a word, and std::length_error for one past its int indices.
HalfEdgeMesh half_edge_mesh(const TriangleMesh& mesh);

}  // namespace plumb

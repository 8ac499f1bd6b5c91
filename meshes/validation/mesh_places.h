#pragma once

#include <cstdint>
#include <vector>

#include "meshes/triangle_mesh.h"

namespace plumb {

/// What vertices share. Requires finite numbers.
struct MeshPlaces {
  /// Of each vertex, the lowest one that has its position; 0 and -0 are equal.
  std::vector<std::uint32_t> place_of;
  /// Vertices whose position, normal and texture coordinate a lower one has, and others whose position a lower one has;
  /// ascending.
  std::vector<std::uint32_t> duplicates, seams;
};
MeshPlaces mesh_places(const TriangleMesh& mesh);

}  // namespace plumb

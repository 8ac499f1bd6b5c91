#pragma once

#include <cstdint>

#include "meshes/generators/mesh_kind.h"

namespace plumb {

/// The number of triangles that is asked for. Throws InputError unless it is from 1 to 100 million.
std::uint64_t asked_triangles(const MeshRequest& request);

/// The least n >= first with triangles_of(n) >= asked; triangles_of grows at least as n does.
template <class TrianglesOf>
std::uint32_t least_size(std::uint64_t asked, std::uint32_t first, TrianglesOf triangles_of) {
  std::uint32_t n = first;
  while (triangles_of(std::uint64_t{n}) < asked) ++n;
  return n;
}

}  // namespace plumb

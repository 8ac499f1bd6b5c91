#include "meshes/validation/mesh_places.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace plumb {
namespace {

/// The first coordinate stands beside the index: it decides most comparisons without a look at the mesh.
struct Entry {
  double x;
  std::uint32_t vertex;
};

template <class Triple>
int compared(const Triple& a, const Triple& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (a[axis] != b[axis]) return a[axis] < b[axis] ? -1 : 1;
  return 0;
}

/// The order of what is stored with two vertices of one position.
int compared_attributes(const TriangleMesh& mesh, std::uint32_t a, std::uint32_t b) {
  if (!mesh.normals.empty())
    if (const int order = compared(mesh.normals[a], mesh.normals[b])) return order;
  if (mesh.texcoords.empty()) return 0;
  const TexCoord &s = mesh.texcoords[a], &t = mesh.texcoords[b];
  if (s.u != t.u) return s.u < t.u ? -1 : 1;
  return s.v == t.v ? 0 : s.v < t.v ? -1 : 1;
}

/// Equal positions lie together, and within them equal attributes, the lowest index first.
std::vector<Entry> sorted_vertices(const TriangleMesh& mesh) {
  std::vector<Entry> entries(mesh.positions.size());
  for (std::size_t i = 0; i < entries.size(); ++i) entries[i] = {mesh.positions[i].x, static_cast<std::uint32_t>(i)};
  std::ranges::sort(entries, [&](const Entry& a, const Entry& b) {
    if (a.x != b.x) return a.x < b.x;
    if (const int order = compared(mesh.positions[a.vertex], mesh.positions[b.vertex])) return order < 0;
    if (const int order = compared_attributes(mesh, a.vertex, b.vertex)) return order < 0;
    return a.vertex < b.vertex;
  });
  return entries;
}

}  // namespace

MeshPlaces mesh_places(const TriangleMesh& mesh) {
  MeshPlaces places;
  places.place_of.resize(mesh.positions.size());
  const std::vector<Entry> entries = sorted_vertices(mesh);
  for (std::size_t begin = 0, end = 0; begin < entries.size(); begin = end) {
    std::uint32_t lowest = entries[begin].vertex;
    for (end = begin; end < entries.size(); ++end) {
      if (mesh.positions[entries[end].vertex] != mesh.positions[entries[begin].vertex]) break;
      lowest = std::min(lowest, entries[end].vertex);
    }
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t vertex = entries[i].vertex;
      places.place_of[vertex] = lowest;
      if (i > begin && compared_attributes(mesh, entries[i - 1].vertex, vertex) == 0)
        places.duplicates.push_back(vertex);
      else if (vertex != lowest)
        places.seams.push_back(vertex);
    }
  }
  std::ranges::sort(places.duplicates);
  std::ranges::sort(places.seams);
  return places;
}

}  // namespace plumb

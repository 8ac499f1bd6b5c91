#include "meshes/editing/manifold.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace plumb {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// The directed edge behind corner `corner % 3` of triangle `corner / 3`.
struct DirectedEdge {
  std::uint32_t from, to;
  std::size_t corner;
  friend bool operator<(const DirectedEdge& a, const DirectedEdge& b) {
    return a.from != b.from ? a.from < b.from : a.to != b.to ? a.to < b.to : a.corner < b.corner;
  }
};

std::size_t next_corner(std::size_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

std::vector<DirectedEdge> sorted_edges(const TriangleMesh& mesh) {
  std::vector<DirectedEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::size_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner) {
    const auto& t = mesh.triangles[corner / 3];
    edges.push_back({t[corner % 3], t[(corner + 1) % 3], corner});
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Where the edge lies in the sorted list; kNone if no triangle runs through it in that direction.
std::size_t find_edge(const std::vector<DirectedEdge>& edges, std::uint32_t from, std::uint32_t to) {
  const auto found = std::lower_bound(edges.begin(), edges.end(), DirectedEdge{from, to, 0});
  if (found == edges.end() || found->from != from || found->to != to) return kNone;
  return static_cast<std::size_t>(found - edges.begin());
}

/// How many corners of the vertex that `edges[first]` leaves lie in one fan with it.
std::size_t fan_size(const TriangleMesh& mesh, const std::vector<DirectedEdge>& edges, std::size_t first) {
  const std::uint32_t vertex = edges[first].from;
  // One turn: across the edge that comes in, then, if a boundary stops it, across the one that leaves.
  std::size_t size = 1;
  std::size_t at = first;
  for (;;) {
    const std::size_t incoming = next_corner(next_corner(edges[at].corner));
    at = find_edge(edges, vertex, mesh.triangles[incoming / 3][incoming % 3]);
    if (at == first) return size;
    if (at == kNone) break;
    ++size;
  }
  for (at = find_edge(edges, edges[first].to, vertex); at != kNone; ++size) {
    const std::size_t leaving = next_corner(edges[at].corner);
    at = find_edge(edges, mesh.triangles[leaving / 3][next_corner(leaving) % 3], vertex);
  }
  return size;
}

}  // namespace

std::optional<std::string> manifold_fault(const TriangleMesh& mesh) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    if (a == b || b == c || c == a)
      return "triangle " + std::to_string(i) + " has vertex " + std::to_string(b == c ? b : a) + " twice";
  }
  const std::vector<DirectedEdge> edges = sorted_edges(mesh);
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const DirectedEdge &e = edges[i - 1], &f = edges[i];
    if (e.from == f.from && e.to == f.to)
      return "triangles " + std::to_string(e.corner / 3) + " and " + std::to_string(f.corner / 3) +
             " both run from vertex " + std::to_string(e.from) + " to vertex " + std::to_string(e.to);
  }
  for (std::size_t first = 0, end = 0; first < edges.size(); first = end) {
    for (end = first; end < edges.size() && edges[end].from == edges[first].from;) ++end;
    if (fan_size(mesh, edges, first) != end - first)
      return "the triangles at vertex " + std::to_string(edges[first].from) + " form more than one fan";
  }
  return std::nullopt;
}

}  // namespace plumb

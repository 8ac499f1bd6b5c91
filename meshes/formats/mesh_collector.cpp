#include "meshes/formats/mesh_collector.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/math/input_error.h"

namespace plumb {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;

/// Puts the value of a vertex into a list that is made with the first one.
template <class Value>
void put(std::vector<Value>& values, std::vector<bool>& has, std::size_t& count, std::size_t vertices,
         std::size_t reserved, std::uint32_t vertex, const Value& value) {
  if (values.empty()) values.reserve(reserved);
  if (values.size() < vertices) values.resize(vertices);
  if (has.size() < vertices) has.resize(vertices);
  if (!has[vertex]) ++count;
  has[vertex] = true;
  values[vertex] = value;
}

template <class Value>
void discard(std::vector<Value>& values) {
  values = std::vector<Value>();
}

}  // namespace

void MeshCollector::reserve(std::size_t vertices, std::size_t triangles) {
  reserved_vertices_ = vertices;
  reserved_triangles_ = triangles;
  mesh_.positions.reserve(vertices);
  mesh_.triangles.reserve(triangles);
}

std::uint32_t MeshCollector::add_vertex(const Point3& position) {
  if (mesh_.positions.size() > std::numeric_limits<std::int32_t>::max())
    fail("more vertices than an int counts; expected fewer");
  mesh_.positions.emplace_back();
  const auto vertex = static_cast<std::uint32_t>(mesh_.positions.size() - 1);
  set_position(vertex, position);
  return vertex;
}

void MeshCollector::set_position(std::uint32_t vertex, const Point3& position) {
  check_vertex(vertex);
  if (!is_finite(position))
    fail("a coordinate of vertex " + std::to_string(vertex) + " is not finite; expected finite numbers");
  mesh_.positions[vertex] = position;
}

void MeshCollector::set_normal(std::uint32_t vertex, const Normal3& normal) {
  check_vertex(vertex);
  if (!is_finite(normal))
    fail("the normal of vertex " + std::to_string(vertex) + " is not finite; expected finite numbers");
  if (attributes_ == Attributes::kOfVertices) {
    put(mesh_.normals, has_normal_, normals_, vertices(), reserved_vertices_, vertex, normal);
    return;
  }
  corner_of(vertex, &Pending::has_normal).normal = {static_cast<float>(normal.x), static_cast<float>(normal.y),
                                                    static_cast<float>(normal.z)};
}

void MeshCollector::set_texcoord(std::uint32_t vertex, const TexCoord& texcoord) {
  check_vertex(vertex);
  if (!std::isfinite(texcoord.u) || !std::isfinite(texcoord.v)) {
    fail("the texture coordinate of vertex " + std::to_string(vertex) + " is not finite; expected finite numbers");
  }
  if (attributes_ == Attributes::kOfVertices) {
    put(mesh_.texcoords, has_texcoord_, texcoords_, vertices(), reserved_vertices_, vertex, texcoord);
    return;
  }
  corner_of(vertex, &Pending::has_texcoord).texcoord = {static_cast<float>(texcoord.u), static_cast<float>(texcoord.v)};
}

MeshCollector::Pending& MeshCollector::corner_of(std::uint32_t vertex, bool Pending::*has) {
  if (pending_.empty() || pending_.back().vertex != vertex || pending_.back().*has)
    pending_.emplace_back().vertex = vertex;
  pending_.back().*has = true;
  return pending_.back();
}

std::uint32_t MeshCollector::add_face(std::span<const std::uint32_t> vertices) {
  if (vertices.size() < 3) {
    fail("face " + std::to_string(faces_) + " has " + std::to_string(vertices.size()) +
         " corners; expected three or more");
  }
  for (const std::uint32_t vertex : vertices) check_vertex(vertex);
  const bool of_corners = attributes_ == Attributes::kOfCorners;
  corners_.assign(of_corners ? vertices.size() : 0, {});
  std::size_t taken = 0;
  for (std::size_t i = 0; i < corners_.size() && taken < pending_.size(); ++i) {
    if (pending_[taken].vertex == vertices[i]) corners_[i] = pending_[taken++];
  }
  if (taken < pending_.size())
    fail("face " + std::to_string(faces_) + " has other corners than its normals; expected the same");
  pending_.clear();
  for (std::size_t i = 2; i < vertices.size(); ++i) {
    mesh_.triangles.push_back({vertices[0], vertices[i - 1], vertices[i]});
    if (of_corners) add_corners_of_triangle(corners_[0], corners_[i - 1], corners_[i]);
  }
  return static_cast<std::uint32_t>(faces_++);
}

void MeshCollector::add_corners_of_triangle(const Pending& a, const Pending& b, const Pending& c) {
  if (!a.has_normal || !b.has_normal || !c.has_normal) {
    every_corner_has_normal_ = false;
    discard(corner_normals_);
  }
  if (!a.has_texcoord || !b.has_texcoord || !c.has_texcoord) {
    every_corner_has_texcoord_ = false;
    discard(corner_texcoords_);
  }
  if (every_corner_has_normal_) {
    if (corner_normals_.empty()) corner_normals_.reserve(3 * reserved_triangles_);
    corner_normals_.insert(corner_normals_.end(), {a.normal, b.normal, c.normal});
  }
  if (every_corner_has_texcoord_) {
    if (corner_texcoords_.empty()) corner_texcoords_.reserve(3 * reserved_triangles_);
    corner_texcoords_.insert(corner_texcoords_.end(), {a.texcoord, b.texcoord, c.texcoord});
  }
}

TriangleMesh MeshCollector::finish() {
  if (attributes_ == Attributes::kOfCorners) {
    keep_extras_of_corners();
  } else {
    if (normals_ < vertices()) discard(mesh_.normals);
    if (texcoords_ < vertices()) discard(mesh_.texcoords);
  }
  return std::move(mesh_);
}

void MeshCollector::check_vertex(std::uint64_t vertex) const {
  if (vertex >= mesh_.positions.size()) {
    fail("face " + std::to_string(faces_) + " names vertex " + std::to_string(vertex) +
         "; expected the index of one of " + std::to_string(mesh_.positions.size()) + " vertices");
  }
}

void MeshCollector::keep_extras_of_corners() {
  if (corner_normals_.empty() && corner_texcoords_.empty()) return;
  if (mesh_.triangles.size() > kNone / 3) fail("more corners than 32 bits count; expected fewer");
  move_corners_to_vertices(representatives());
}

/// By the normals, then the texture coordinates, as numbers: 0 equals -0.
int MeshCollector::compare_corners(std::size_t a, std::size_t b) const {
  const auto compare = [&](const auto& values) {
    if (values.empty()) return 0;
    for (std::size_t i = 0; i < values[a].size(); ++i) {
      if (values[a][i] != values[b][i]) return values[a][i] < values[b][i] ? -1 : 1;
    }
    return 0;
  };
  const int by_normal = compare(corner_normals_);
  return by_normal != 0 ? by_normal : compare(corner_texcoords_);
}

/// Of each corner, the first one of the same vertex with the same values.
std::vector<std::uint32_t> MeshCollector::representatives() const {
  const std::size_t corners = 3 * mesh_.triangles.size();
  std::vector<std::uint32_t> representative(corners), first(vertices(), kNone), others;
  for (std::size_t i = 0; i < corners; ++i) {
    const auto corner = static_cast<std::uint32_t>(i);
    std::uint32_t& of_vertex = first[vertex_of(i)];
    if (of_vertex == kNone) of_vertex = corner;
    representative[i] = of_vertex;
    if (compare_corners(of_vertex, i) != 0) others.push_back(corner);
  }
  const auto is_before = [&](std::uint32_t a, std::uint32_t b) {
    if (vertex_of(a) != vertex_of(b)) return vertex_of(a) < vertex_of(b);
    const int order = compare_corners(a, b);
    return order != 0 ? order < 0 : a < b;
  };
  std::sort(others.begin(), others.end(), is_before);
  for (std::size_t i = 0; i < others.size(); ++i) {
    const bool same =
        i > 0 && vertex_of(others[i]) == vertex_of(others[i - 1]) && compare_corners(others[i], others[i - 1]) == 0;
    representative[others[i]] = same ? representative[others[i - 1]] : others[i];
  }
  return representative;
}

/// Repeats a vertex for each further representative; see read_with_open_mesh.
void MeshCollector::move_corners_to_vertices(const std::vector<std::uint32_t>& representative) {
  const std::size_t vertices_of_file = vertices();
  std::vector<bool> is_taken(vertices_of_file);
  std::size_t total = vertices_of_file;
  for (std::size_t i = 0; i < representative.size(); ++i) {
    if (representative[i] != i) continue;
    if (is_taken[vertex_of(i)]) ++total;
    is_taken[vertex_of(i)] = true;
  }
  is_taken.assign(vertices_of_file, false);
  if (total > vertices_of_file) mesh_.positions.reserve(total);
  if (!corner_normals_.empty()) mesh_.normals.resize(total);
  if (!corner_texcoords_.empty()) mesh_.texcoords.resize(total);
  for (std::size_t i = 0; i < representative.size(); ++i) {
    std::uint32_t& vertex = vertex_of(i);
    if (representative[i] != i) {
      vertex = vertex_of(representative[i]);
      continue;
    }
    if (is_taken[vertex]) {
      mesh_.positions.push_back(Point3(mesh_.positions[vertex]));
      vertex = static_cast<std::uint32_t>(mesh_.positions.size() - 1);
    } else {
      is_taken[vertex] = true;
    }
    if (!corner_normals_.empty()) {
      const auto& [x, y, z] = corner_normals_[i];
      mesh_.normals[vertex] = {double{x}, double{y}, double{z}};
    }
    if (!corner_texcoords_.empty()) {
      const auto& [u, v] = corner_texcoords_[i];
      mesh_.texcoords[vertex] = {double{u}, double{v}};
    }
  }
}

void MeshCollector::fail(const std::string& what) const { throw InputError({file_}, what); }

}  // namespace plumb

#include "meshes/formats/mesh_collector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "renderer/math/input_error.h"

namespace plumb {

void MeshCollector::reserve(std::size_t vertices, std::size_t faces) {
  mesh_.positions.reserve(vertices);
  mesh_.triangles.reserve(faces);
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
  extras_of(vertex).normal = normal;
}

void MeshCollector::set_texcoord(std::uint32_t vertex, const TexCoord& texcoord) {
  check_vertex(vertex);
  if (!std::isfinite(texcoord.u) || !std::isfinite(texcoord.v)) {
    fail("the texture coordinate of vertex " + std::to_string(vertex) + " is not finite; expected finite numbers");
  }
  extras_of(vertex).texcoord = texcoord;
}

std::uint32_t MeshCollector::add_face(std::span<const std::uint32_t> vertices) {
  if (vertices.size() < 3) {
    fail("face " + std::to_string(faces_) + " has " + std::to_string(vertices.size()) +
         " corners; expected three or more");
  }
  for (const std::uint32_t vertex : vertices) check_vertex(vertex);
  std::vector<Extras> corners(attributes_ == Attributes::kOfCorners ? vertices.size() : 0);
  std::size_t taken = 0;
  for (std::size_t i = 0; i < corners.size() && taken < pending_.size(); ++i) {
    if (pending_[taken].vertex == vertices[i]) corners[i] = pending_[taken++].extras;
  }
  if (taken < pending_.size())
    fail("face " + std::to_string(faces_) + " has other corners than its normals; expected the same");
  pending_.clear();
  for (std::size_t i = 2; i < vertices.size(); ++i) {
    mesh_.triangles.push_back({vertices[0], vertices[i - 1], vertices[i]});
    if (!corners.empty()) extras_.insert(extras_.end(), {corners[0], corners[i - 1], corners[i]});
  }
  return static_cast<std::uint32_t>(faces_++);
}

TriangleMesh MeshCollector::finish() {
  if (any_extras_) attributes_ == Attributes::kOfCorners ? keep_extras_of_corners() : keep_extras_of_vertices();
  return std::move(mesh_);
}

void MeshCollector::check_vertex(std::uint64_t vertex) const {
  if (vertex >= mesh_.positions.size()) {
    fail("face " + std::to_string(faces_) + " names vertex " + std::to_string(vertex) +
         "; expected the index of one of " + std::to_string(mesh_.positions.size()) + " vertices");
  }
}

MeshCollector::Extras& MeshCollector::extras_of(std::uint32_t vertex) {
  any_extras_ = true;
  if (attributes_ == Attributes::kOfVertices) {
    if (extras_.size() < mesh_.positions.size()) extras_.resize(mesh_.positions.size());
    return extras_[vertex];
  }
  if (pending_.empty() || pending_.back().vertex != vertex) pending_.push_back({vertex, {}});
  return pending_.back().extras;
}

void MeshCollector::keep_extras_of_vertices() {
  extras_.resize(mesh_.positions.size());
  const bool normals =
      std::all_of(extras_.begin(), extras_.end(), [](const Extras& e) { return e.normal.has_value(); });
  const bool texcoords =
      std::all_of(extras_.begin(), extras_.end(), [](const Extras& e) { return e.texcoord.has_value(); });
  for (const Extras& extras : extras_) {
    if (normals) mesh_.normals.push_back(*extras.normal);
    if (texcoords) mesh_.texcoords.push_back(*extras.texcoord);
  }
}

void MeshCollector::keep_extras_of_corners() {
  if (extras_.empty()) return;
  const bool normals =
      std::all_of(extras_.begin(), extras_.end(), [](const Extras& e) { return e.normal.has_value(); });
  const bool texcoords =
      std::all_of(extras_.begin(), extras_.end(), [](const Extras& e) { return e.texcoord.has_value(); });
  if (!normals && !texcoords) return;
  using Values = std::array<double, 5>;
  std::vector<std::optional<Values>> first(mesh_.positions.size());
  std::map<std::pair<std::uint32_t, Values>, std::uint32_t> repeated;
  if (normals) mesh_.normals.resize(first.size());
  if (texcoords) mesh_.texcoords.resize(first.size());
  for (std::size_t i = 0; i < extras_.size(); ++i) {
    std::uint32_t& vertex = mesh_.triangles[i / 3][i % 3];
    const Normal3 n = normals ? *extras_[i].normal : Normal3{};
    const TexCoord t = texcoords ? *extras_[i].texcoord : TexCoord{};
    const Values values = {n.x, n.y, n.z, t.u, t.v};
    if (!first[vertex]) {
      first[vertex] = values;
      if (normals) mesh_.normals[vertex] = n;
      if (texcoords) mesh_.texcoords[vertex] = t;
    } else if (*first[vertex] != values) {
      const auto [copy, is_new] =
          repeated.try_emplace({vertex, values}, static_cast<std::uint32_t>(mesh_.positions.size()));
      if (is_new) {
        mesh_.positions.push_back(Point3(mesh_.positions[vertex]));
        if (normals) mesh_.normals.push_back(n);
        if (texcoords) mesh_.texcoords.push_back(t);
      }
      vertex = copy->second;
    }
  }
}

void MeshCollector::fail(const std::string& what) const { throw InputError({file_}, what); }

}  // namespace plumb

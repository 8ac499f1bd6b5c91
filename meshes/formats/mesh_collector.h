#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "meshes/triangle_mesh.h"

namespace plumb {

/// Builds a TriangleMesh from the reports of a file reader, one vertex and one face at a time. Every check
/// is made here once more, whatever the reader checked: wrong reports throw InputError, with the file.
class MeshCollector {
 public:
  /// Whether normals and texture coordinates belong to vertices or to the corners of faces.
  enum class Attributes { kOfVertices, kOfCorners };

  MeshCollector(std::string file, Attributes attributes) : file_(std::move(file)), attributes_(attributes) {}

  void reserve(std::size_t vertices, std::size_t faces);
  /// Returns the index of the new vertex.
  std::uint32_t add_vertex(const Point3& position);
  void set_position(std::uint32_t vertex, const Point3& position);
  /// Of the vertex; with kOfCorners, of its corner in the face that is added next. There, the corners must
  /// come in the order of the face.
  void set_normal(std::uint32_t vertex, const Normal3& normal);
  void set_texcoord(std::uint32_t vertex, const TexCoord& texcoord);
  /// Adds a fan of triangles around the first of three or more vertices. Returns the index of the face.
  std::uint32_t add_face(std::span<const std::uint32_t> vertices);

  std::size_t vertices() const { return mesh_.positions.size(); }
  std::size_t faces() const { return faces_; }
  /// The mesh; see read_with_open_mesh for what becomes of normals and texture coordinates. Ends the collector.
  TriangleMesh finish();

 private:
  struct Extras {
    std::optional<Normal3> normal;
    std::optional<TexCoord> texcoord;
  };
  struct Pending {
    std::uint32_t vertex;
    Extras extras;
  };

  void check_vertex(std::uint64_t vertex) const;
  Extras& extras_of(std::uint32_t vertex);
  void keep_extras_of_vertices();
  void keep_extras_of_corners();
  [[noreturn]] void fail(const std::string& what) const;

  std::string file_;
  Attributes attributes_;
  TriangleMesh mesh_;
  std::size_t faces_ = 0;
  /// One a vertex or three a triangle, once there is any.
  std::vector<Extras> extras_;
  bool any_extras_ = false;
  std::vector<Pending> pending_;
};

}  // namespace plumb

#pragma once

#include <array>
#include <cstdint>
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

  void reserve(std::size_t vertices, std::size_t triangles);
  /// Returns the index of the new vertex.
  std::uint32_t add_vertex(const Point3& position);
  void set_position(std::uint32_t vertex, const Point3& position);
  /// Of the vertex; with kOfCorners, of its corner in the face that is added next, in single precision. There, the
  /// corners must come in the order of the face.
  void set_normal(std::uint32_t vertex, const Normal3& normal);
  void set_texcoord(std::uint32_t vertex, const TexCoord& texcoord);
  /// Adds a fan of triangles around the first of three or more vertices. Returns the index of the face.
  std::uint32_t add_face(std::span<const std::uint32_t> vertices);

  std::size_t vertices() const { return mesh_.positions.size(); }
  std::size_t faces() const { return faces_; }
  /// The mesh; see read_with_open_mesh for what becomes of normals and texture coordinates. Ends the collector.
  TriangleMesh finish();

 private:
  /// Of a corner, in single precision to save memory: a mesh has six times as many corners as vertices.
  using CornerNormal = std::array<float, 3>;
  using CornerTexcoord = std::array<float, 2>;
  struct Pending {
    std::uint32_t vertex = 0;
    bool has_normal = false, has_texcoord = false;
    CornerNormal normal{};
    CornerTexcoord texcoord{};
  };

  void check_vertex(std::uint64_t vertex) const;
  /// The last corner, or a new one if that is another vertex's or has the attribute already.
  Pending& corner_of(std::uint32_t vertex, bool Pending::*has);
  void add_corners_of_triangle(const Pending& a, const Pending& b, const Pending& c);
  void keep_extras_of_corners();
  int compare_corners(std::size_t a, std::size_t b) const;
  std::vector<std::uint32_t> representatives() const;
  void move_corners_to_vertices(const std::vector<std::uint32_t>& representative);
  std::uint32_t& vertex_of(std::size_t corner) { return mesh_.triangles[corner / 3][corner % 3]; }
  std::uint32_t vertex_of(std::size_t corner) const { return mesh_.triangles[corner / 3][corner % 3]; }
  [[noreturn]] void fail(const std::string& what) const;

  std::string file_;
  Attributes attributes_;
  TriangleMesh mesh_;
  std::size_t faces_ = 0, reserved_vertices_ = 0, reserved_triangles_ = 0;
  /// How many different vertices have one.
  std::size_t normals_ = 0, texcoords_ = 0;
  std::vector<bool> has_normal_, has_texcoord_;
  /// Three a triangle, while no corner lacked one.
  std::vector<CornerNormal> corner_normals_;
  std::vector<CornerTexcoord> corner_texcoords_;
  bool every_corner_has_normal_ = true, every_corner_has_texcoord_ = true;
  std::vector<Pending> pending_, corners_;
};

}  // namespace plumb

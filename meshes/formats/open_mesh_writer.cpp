#include "meshes/formats/open_mesh_writer.h"

#include <OpenMesh/Core/IO/exporter/BaseExporter.hh>
#include <OpenMesh/Core/IO/writer/OBJWriter.hh>
#include <OpenMesh/Core/IO/writer/OFFWriter.hh>
#include <OpenMesh/Core/IO/writer/PLYWriter.hh>
#include <limits>
#include <vector>

#include "meshes/formats/open_mesh_turn.h"
#include "meshes/formats/write_progress.h"

namespace plumb {
namespace {

using namespace OpenMesh;

/// Shows a TriangleMesh to a writer. OpenMesh's own exporter needs a half-edge mesh, which cannot hold every mesh.
class MeshExporter final : public IO::BaseExporter {
 public:
  MeshExporter(const TriangleMesh& mesh, const std::function<void(double)>& progress)
      : mesh_(mesh), progress_(progress, mesh.positions.size() + mesh.triangles.size()) {}

  Vec3f point(VertexHandle v) const override {
    progress_.step();
    return single(mesh_.positions[index(v)]);
  }
  Vec3f normal(VertexHandle v) const override {
    return mesh_.normals.empty() ? Vec3f(0.F) : single(mesh_.normals[index(v)]);
  }
  /// Zeros where there are none: the OBJ writer asks all the same.
  Vec2f texcoord(VertexHandle v) const override {
    if (mesh_.texcoords.empty()) return Vec2f(0.F);
    const TexCoord& t = mesh_.texcoords[index(v)];
    return {static_cast<float>(t.u), static_cast<float>(t.v)};
  }
  unsigned int get_vhandles(FaceHandle face, std::vector<VertexHandle>& corners) const override {
    progress_.step();
    const auto& triangle = mesh_.triangles[static_cast<std::size_t>(face.idx())];
    corners.clear();
    for (const std::uint32_t vertex : triangle) corners.emplace_back(static_cast<int>(vertex));
    return 3;
  }
  size_t n_vertices() const override { return mesh_.positions.size(); }
  size_t n_faces() const override { return mesh_.triangles.size(); }
  size_t n_edges() const override { return 0; }
  bool is_triangle_mesh() const override { return true; }
  /// The PLY writer asks it for properties of further names without a look whether there is one.
  const BaseKernel* kernel() override { return &no_properties_; }
  bool has_vertex_normals() const override { return !mesh_.normals.empty(); }
  bool has_vertex_texcoords() const override { return !mesh_.texcoords.empty(); }

  // What a TriangleMesh does not hold.
  Vec3d pointd(VertexHandle v) const override { return Vec3d(point(v)); }
  Vec3d normald(VertexHandle v) const override { return Vec3d(normal(v)); }
  bool is_point_double() const override { return false; }
  bool is_normal_double() const override { return false; }
  Vec3uc color(VertexHandle) const override { return Vec3uc(0); }
  Vec4uc colorA(VertexHandle) const override { return Vec4uc(0); }
  Vec3ui colori(VertexHandle) const override { return Vec3ui(0); }
  Vec4ui colorAi(VertexHandle) const override { return Vec4ui(0); }
  Vec3f colorf(VertexHandle) const override { return Vec3f(0.F); }
  Vec4f colorAf(VertexHandle) const override { return Vec4f(0.F); }
  Vec2f texcoord(HalfedgeHandle) const override { return Vec2f(0.F); }
  Attributes::StatusInfo status(VertexHandle) const override { return {}; }
  HalfedgeHandle getHeh(FaceHandle, VertexHandle) const override { return HalfedgeHandle(); }
  unsigned int get_face_texcoords(std::vector<Vec2f>&) const override { return 0; }
  Vec3f normal(FaceHandle) const override { return Vec3f(0.F); }
  Vec3d normald(FaceHandle) const override { return {}; }
  Vec3uc color(FaceHandle) const override { return Vec3uc(0); }
  Vec4uc colorA(FaceHandle) const override { return Vec4uc(0); }
  Vec3ui colori(FaceHandle) const override { return Vec3ui(0); }
  Vec4ui colorAi(FaceHandle) const override { return Vec4ui(0); }
  Vec3f colorf(FaceHandle) const override { return Vec3f(0.F); }
  Vec4f colorAf(FaceHandle) const override { return Vec4f(0.F); }
  Attributes::StatusInfo status(FaceHandle) const override { return {}; }
  Vec3uc color(EdgeHandle) const override { return Vec3uc(0); }
  Vec4uc colorA(EdgeHandle) const override { return Vec4uc(0); }
  Vec3ui colori(EdgeHandle) const override { return Vec3ui(0); }
  Vec4ui colorAi(EdgeHandle) const override { return Vec4ui(0); }
  Vec3f colorf(EdgeHandle) const override { return Vec3f(0.F); }
  Vec4f colorAf(EdgeHandle) const override { return Vec4f(0.F); }
  Attributes::StatusInfo status(EdgeHandle) const override { return {}; }
  int get_halfedge_id(VertexHandle) override { return -1; }
  int get_halfedge_id(FaceHandle) override { return -1; }
  int get_next_halfedge_id(HalfedgeHandle) override { return -1; }
  int get_to_vertex_id(HalfedgeHandle) override { return -1; }
  int get_face_id(HalfedgeHandle) override { return -1; }
  Attributes::StatusInfo status(HalfedgeHandle) const override { return {}; }

 private:
  static std::size_t index(VertexHandle v) { return static_cast<std::size_t>(v.idx()); }
  template <class Triple>
  static Vec3f single(const Triple& t) {
    return {static_cast<float>(t.x), static_cast<float>(t.y), static_cast<float>(t.z)};
  }

  const TriangleMesh& mesh_;
  mutable WriteProgress progress_;
  BaseKernel no_properties_;
};

}  // namespace

bool write_with_open_mesh(const TriangleMesh& mesh, const std::string& ending, bool text, std::ostream& out,
                          const std::function<void(double)>& progress) {
  MeshExporter exporter(mesh, progress);
  IO::Options options;
  if (!mesh.normals.empty()) options += IO::Options::VertexNormal;
  if (!mesh.texcoords.empty()) options += IO::Options::VertexTexCoord;
  if (!text && ending != ".obj") options += IO::Options::Binary;
  constexpr std::streamsize kDigits = std::numeric_limits<float>::max_digits10;
  const OpenMeshTurn turn;
  if (ending == ".obj") return IO::OBJWriter().write(out, exporter, options, kDigits);
  if (ending == ".ply") return IO::PLYWriter().write(out, exporter, options, kDigits);
  return IO::OFFWriter().write(out, exporter, options, kDigits);
}

}  // namespace plumb

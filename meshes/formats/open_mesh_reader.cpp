#include "meshes/formats/open_mesh_reader.h"

#include <OpenMesh/Core/IO/importer/BaseImporter.hh>
#include <OpenMesh/Core/IO/reader/OBJReader.hh>
#include <OpenMesh/Core/IO/reader/OFFReader.hh>
#include <OpenMesh/Core/IO/reader/PLYReader.hh>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "meshes/formats/file_bytes.h"
#include "meshes/formats/mesh_collector.h"
#include "meshes/formats/open_mesh_turn.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

using namespace OpenMesh;

/// Hands what a reader reports to a MeshCollector. OpenMesh's own importer builds a half-edge mesh, which
/// cannot hold every mesh: it would split vertices and drop faces.
class CollectingImporter final : public IO::BaseImporter {
 public:
  CollectingImporter(MeshCollector& collector, const PreparedMesh& prepared)
      : collector_(collector), prepared_(prepared) {}

  VertexHandle add_vertex(const Vec3f& p) override {
    if (collector_.vertices() < prepared_.vertices) return handle(collector_.add_vertex({p[0], p[1], p[2]}));
    return handle(static_cast<std::uint32_t>(prepared_.vertices + stand_ins_++));
  }
  VertexHandle add_vertex() override { return add_vertex(Vec3f(0.F)); }
  void set_point(VertexHandle v, const Vec3f& p) override { collector_.set_position(index(v), {p[0], p[1], p[2]}); }
  void set_normal(VertexHandle v, const Vec3f& n) override { collector_.set_normal(index(v), {n[0], n[1], n[2]}); }
  void set_normal(VertexHandle v, const Vec3d& n) override { collector_.set_normal(index(v), {n[0], n[1], n[2]}); }
  void set_texcoord(VertexHandle v, const Vec2f& t) override { collector_.set_texcoord(index(v), {t[0], t[1]}); }

  FaceHandle add_face(const VHandles& corners) override {
    vertices_.clear();
    for (const VertexHandle v : corners) vertices_.push_back(index(v));
    return FaceHandle(static_cast<int>(collector_.add_face(vertices_)));
  }

  /// Already done, with numbers that have been checked.
  void reserve(unsigned int, unsigned int, unsigned int) override {}
  size_t n_vertices() const override { return collector_.vertices() + stand_ins_; }
  size_t n_faces() const override { return collector_.faces(); }
  size_t n_edges() const override { return 0; }

  // What a TriangleMesh does not hold: edges, colours, statuses, face normals, textures of corners.
  HalfedgeHandle add_edge(VertexHandle, VertexHandle) override { return HalfedgeHandle(); }
  FaceHandle add_face(HalfedgeHandle) override { return FaceHandle(); }
  void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec2f>&) override {}
  void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec3f>&) override {}
  void set_face_texindex(FaceHandle, int) override {}
  void set_halfedge(VertexHandle, HalfedgeHandle) override {}
  void set_color(VertexHandle, const Vec3uc&) override {}
  void set_color(VertexHandle, const Vec4uc&) override {}
  void set_color(VertexHandle, const Vec3f&) override {}
  void set_color(VertexHandle, const Vec4f&) override {}
  void set_status(VertexHandle, const Attributes::StatusInfo&) override {}
  void set_next(HalfedgeHandle, HalfedgeHandle) override {}
  void set_face(HalfedgeHandle, FaceHandle) override {}
  void request_face_texcoords2D() override {}
  void set_texcoord(HalfedgeHandle, const Vec2f&) override {}
  void set_texcoord(VertexHandle, const Vec3f&) override {}
  void set_texcoord(HalfedgeHandle, const Vec3f&) override {}
  void set_status(HalfedgeHandle, const Attributes::StatusInfo&) override {}
  void set_color(EdgeHandle, const Vec3uc&) override {}
  void set_color(EdgeHandle, const Vec4uc&) override {}
  void set_color(EdgeHandle, const Vec3f&) override {}
  void set_color(EdgeHandle, const Vec4f&) override {}
  void set_status(EdgeHandle, const Attributes::StatusInfo&) override {}
  void set_normal(FaceHandle, const Vec3f&) override {}
  void set_normal(FaceHandle, const Vec3d&) override {}
  void set_color(FaceHandle, const Vec3uc&) override {}
  void set_color(FaceHandle, const Vec4uc&) override {}
  void set_color(FaceHandle, const Vec3f&) override {}
  void set_color(FaceHandle, const Vec4f&) override {}
  void set_status(FaceHandle, const Attributes::StatusInfo&) override {}
  void add_texture_information(int, std::string) override {}

 private:
  static VertexHandle handle(std::uint32_t vertex) { return VertexHandle(static_cast<int>(vertex)); }
  /// A handle that is not valid becomes an index that is out of range.
  std::uint32_t index(VertexHandle v) const {
    const auto vertex = static_cast<std::uint32_t>(v.idx());
    const std::size_t stand_in = vertex - prepared_.vertices;
    const bool stands_in = vertex >= prepared_.vertices && stand_in < prepared_.stand_ins.size();
    return stands_in ? prepared_.stand_ins[stand_in] : vertex;
  }

  MeshCollector& collector_;
  const PreparedMesh& prepared_;
  std::size_t stand_ins_ = 0;
  std::vector<std::uint32_t> vertices_;
};

PreparedMesh prepare(const std::string& ending, std::string content, const std::string& file) {
  if (ending == ".obj") return prepare_obj(content, file);
  return prepare_off(std::move(content), file);
}

bool run_reader(const std::string& ending, const std::string& file, std::istream& in, IO::BaseImporter& importer,
                IO::Options& options) {
  if (ending == ".obj") return IO::OBJReader().read(in, importer, options);
  // These two read what their first lines promise without a look at the stream's state.
  in.exceptions(std::ios::failbit | std::ios::badbit);
  if (ending == ".ply") return IO::PLYReader().read(in, importer, options);
  // The OFF reader learns the kind of the file (NOFF, BINARY, ...) from its name alone.
  return IO::OFFReader().can_u_read(file) && IO::OFFReader().read(in, importer, options);
}

}  // namespace

TriangleMesh read_with_open_mesh(std::string content, const std::filesystem::path& path, MeshNotes& notes) {
  return read_with_open_mesh(prepare(lower_case_ending(path), std::move(content), path.string()), path, notes);
}

TriangleMesh read_with_open_mesh(PreparedMesh prepared, const std::filesystem::path& path, MeshNotes& notes) {
  const std::string file = path.string();
  const std::string ending = lower_case_ending(path);
  const bool of_corners = ending == ".obj";
  MeshCollector collector(file,
                          of_corners ? MeshCollector::Attributes::kOfCorners : MeshCollector::Attributes::kOfVertices);
  collector.reserve(prepared.vertices, prepared.triangles);
  bool was_read = false;
  {
    CollectingImporter importer(collector, prepared);
    IO::Options options = IO::Options::VertexNormal | IO::Options::VertexTexCoord;
    if (prepared.binary) options += IO::Options::Binary;
    std::istringstream in(std::move(prepared.bytes));  // the bytes go before the mesh is finished
    try {
      const OpenMeshTurn turn;
      was_read = run_reader(ending, file, in, importer, options);
    } catch (const std::ios_base::failure&) {
    }
  }
  if (!was_read || collector.faces() != prepared.faces) {
    throw InputError({file}, "OpenMesh reads " + std::to_string(collector.faces()) + " of " +
                                 std::to_string(prepared.faces) + " faces; expected a file that it reads whole");
  }
  TriangleMesh mesh = collector.finish();
  notes = std::move(prepared.notes);
  if (const std::size_t repeated = mesh.positions.size() - prepared.vertices; repeated > 0) {
    notes.sentences.push_back(
        counted(repeated, "vertex is added, because corners", "vertices are added, because corners") +
        " of a vertex differ in normal or texture coordinate");
  }
  return mesh;
}

}  // namespace plumb

#include "meshes/editing/simplify.h"

// QuadricT.hh uses the first without including it.
// clang-format off
#include <OpenMesh/Core/Utils/vector_traits.hh>
#include <OpenMesh/Core/Geometry/QuadricT.hh>
// clang-format on
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModBaseT.hh>
#include <OpenMesh/Tools/Decimater/Observer.hh>
#include <algorithm>
#include <cmath>

#include "meshes/editing/half_edge_mesh.h"
#include "renderer/math/bounds3.h"

namespace plumb {
namespace {

using OpenMesh::Vec3d;
using Quadric = OpenMesh::Geometry::QuadricT<double>;

/// The module of OpenMesh, ModQuadricT, gives boundaries no cost and takes a cost that rounds below zero for a
/// forbidden collapse, so this is one of our own.
template <class MeshT>
class PlanesOfTriangles : public OpenMesh::Decimater::ModBaseT<MeshT> {
 public:
  DECIMATING_MODULE(PlanesOfTriangles, MeshT, PlanesOfTriangles);

  explicit PlanesOfTriangles(MeshT& mesh) : Base(mesh, false) {
    mesh.add_property(quadric_);
    mesh.add_property(area_);
  }
  ~PlanesOfTriangles() override {
    Base::mesh().remove_property(quadric_);
    Base::mesh().remove_property(area_);
  }

  void initialize() override {
    MeshT& mesh = Base::mesh();
    for (const auto v : mesh.vertices()) {
      mesh.property(quadric_, v).clear();
      mesh.property(area_, v) = 0;
    }
    for (const auto f : mesh.faces()) add_triangle(f);
  }

  float collapse_priority(const CollapseInfo& collapse) override {
    return turns_over(collapse) ? static_cast<float>(Base::ILLEGAL_COLLAPSE) : static_cast<float>(cost(collapse));
  }

  void postprocess_collapse(const CollapseInfo& collapse) override {
    const double error = cost(collapse);
    MeshT& mesh = Base::mesh();
    mesh.property(quadric_, collapse.v1) += mesh.property(quadric_, collapse.v0);
    const double area = mesh.property(area_, collapse.v1) += mesh.property(area_, collapse.v0);
    if (area > 0) largest_ = std::max(largest_, std::sqrt(error / area));
  }

  double largest_error() const { return largest_; }

 private:
  /// n has unit length.
  static Quadric plane(const Vec3d& n, const Vec3d& through) { return {n[0], n[1], n[2], -(n | through)}; }

  void add_triangle(const OpenMesh::SmartFaceHandle& face) {
    MeshT& mesh = Base::mesh();
    const Vec3d normal = mesh.calc_face_normal(face);  // zero for a triangle on a line
    const double area = mesh.calc_face_area(face);
    if (!(area > 0)) return;
    for (const auto v : face.vertices()) {
      mesh.property(quadric_, v) += plane(normal, mesh.point(v)) * area;
      mesh.property(area_, v) += area;
    }
    for (const auto h : face.halfedges()) {
      if (!h.opp().is_boundary()) continue;
      const Vec3d along = mesh.point(h.to()) - mesh.point(h.from());
      const Vec3d across = (along % normal).normalize_cond();
      // As much as the square over the edge weighs, so that a boundary holds like a surface.
      const Quadric wall = plane(across, mesh.point(h.to())) * along.sqrnorm();
      mesh.property(quadric_, h.from()) += wall;
      mesh.property(quadric_, h.to()) += wall;
    }
  }

  /// The area times the squared distance, of what both ends stand for from the end that stays.
  double cost(const CollapseInfo& collapse) {
    Quadric both = Base::mesh().property(quadric_, collapse.v0);
    both += Base::mesh().property(quadric_, collapse.v1);
    return std::max(0.0, both(collapse.p1));
  }

  /// Whether a triangle that stays would turn by a right angle or more, or end on a line.
  bool turns_over(const CollapseInfo& collapse) {
    const MeshT& mesh = Base::mesh();
    for (const auto h : mesh.voh_range(collapse.v0)) {
      if (h.is_boundary() || h.to() == collapse.v1 || h.next().to() == collapse.v1) continue;
      const Vec3d p = mesh.point(h.to()), q = mesh.point(h.next().to());
      const Vec3d before = (p - collapse.p0) % (q - collapse.p0), after = (p - collapse.p1) % (q - collapse.p1);
      if (before.sqrnorm() > 0 && !((before | after) > 0)) return true;
    }
    return false;
  }

  OpenMesh::VPropHandleT<Quadric> quadric_;
  /// Of the triangles in the quadric.
  OpenMesh::VPropHandleT<double> area_;
  double largest_ = 0;
};

class Progress final : public OpenMesh::Decimater::Observer {
 public:
  Progress(const std::function<void(double)>& told, std::size_t collapses)
      : Observer(1024), told_(told), collapses_(static_cast<double>(std::max<std::size_t>(collapses, 1))) {}
  void notify(std::size_t step) override {
    if (told_) told_(std::min(1.0, static_cast<double>(step) / collapses_));
  }

 private:
  const std::function<void(double)>& told_;
  double collapses_;
};

/// Moves the mesh into the cube from -1 to 1, so that OpenMesh's costs, in single precision and fourth powers of a
/// length, neither overflow nor vanish. Returns the length that became 1.
double normalize(HalfEdgeMesh& mesh, const TriangleMesh& original) {
  Bounds3 bounds;
  for (const Point3& p : original.positions) bounds.extend(p);
  double half = 0;
  for (int axis = 0; axis < 3; ++axis) half = std::max(half, bounds.max[axis] / 2 - bounds.min[axis] / 2);
  if (!(half > 0)) return 1;
  for (const auto v : mesh.vertices()) {
    const Point3& p = original.positions[static_cast<std::size_t>(v.idx())];
    for (int axis = 0; axis < 3; ++axis) {
      const double middle = bounds.min[axis] / 2 + bounds.max[axis] / 2;
      mesh.point(v)[static_cast<std::size_t>(axis)] = (p[axis] / 2 - middle / 2) / (half / 2);
    }
  }
  return half;
}

/// What is left: the vertices that were not moved into others, in their order, and the triangles.
TriangleMesh kept(const HalfEdgeMesh& mesh, const TriangleMesh& original) {
  TriangleMesh result;
  std::vector<std::uint32_t> number(original.positions.size());
  for (const auto v : mesh.vertices()) {  // passes over those that were deleted
    const auto old = static_cast<std::size_t>(v.idx());
    number[old] = static_cast<std::uint32_t>(result.positions.size());
    result.positions.push_back(original.positions[old]);
    if (!original.normals.empty()) result.normals.push_back(original.normals[old]);
    if (!original.texcoords.empty()) result.texcoords.push_back(original.texcoords[old]);
  }
  for (const auto f : mesh.faces()) {
    std::array<std::uint32_t, 3> triangle{};
    std::size_t corner = 0;
    for (const auto v : f.vertices()) triangle[corner++] = number[static_cast<std::size_t>(v.idx())];
    result.triangles.push_back(triangle);
  }
  return result;
}

}  // namespace

Simplified simplified(const TriangleMesh& mesh, const Simplifying& options) {
  HalfEdgeMesh half_edges = half_edge_mesh(mesh);
  if (mesh.triangles.size() <= options.triangles) return {mesh, 0};
  const double unit = normalize(half_edges, mesh);
  // A collapse takes two triangles.
  Progress progress(options.progress, (mesh.triangles.size() - options.triangles) / 2);
  OpenMesh::Decimater::DecimaterT<HalfEdgeMesh> decimater(half_edges);
  PlanesOfTriangles<HalfEdgeMesh>::Handle planes;
  decimater.add(planes);
  decimater.set_observer(&progress);
  decimater.initialize();
  decimater.decimate_to_faces(0, options.triangles);
  Simplified result{kept(half_edges, mesh), unit * decimater.module(planes).largest_error()};
  if (options.progress) options.progress(1);
  return result;
}

}  // namespace plumb

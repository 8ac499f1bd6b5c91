#include "conformance/subject/kernel_scene.h"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace plumb {
namespace {

constexpr std::uint32_t kNoMesh = 0xffffffff;

/// A surface on the line: without pointers.
struct SurfaceRecord {
  std::uint32_t kind, mesh;
  double center[3], radius, height, tip_z, box_min[3], box_max[3], world_from_object[12];
};

template <std::size_t N>
void copy(double (&to)[N], const double (&from)[N]) {
  std::copy(from, from + N, to);
}

/// What a surface and its record have in common.
template <class To, class From>
void copy_numbers(To& to, const From& from) {
  to.kind = from.kind;
  copy(to.center, from.center);
  to.radius = from.radius;
  to.height = from.height;
  to.tip_z = from.tip_z;
  copy(to.box_min, from.box_min);
  copy(to.box_max, from.box_max);
  copy(to.world_from_object, from.world_from_object);
}

plumb_kind kind_of(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::triangle:
    case ShapeKind::mesh:
      return PLUMB_MESH;
    case ShapeKind::sphere:
      return PLUMB_SPHERE;
    case ShapeKind::box:
      return PLUMB_BOX;
    case ShapeKind::cylinder:
      return PLUMB_CYLINDER;
    case ShapeKind::cone:
      return PLUMB_CONE;
  }
  throw std::logic_error("unknown kind of shape");
}

void put(double (&to)[3], const Point3& p) {
  to[0] = p.x;
  to[1] = p.y;
  to[2] = p.z;
}

plumb_surface surface_of(const SubjectSurface& subject) {
  const Shape& shape = subject.shape;
  plumb_surface surface{};
  surface.kind = kind_of(shape.kind);
  put(surface.center, shape.center);
  surface.radius = shape.radius;
  surface.height = shape.height;
  surface.tip_z = shape.tip_z;
  put(surface.box_min, shape.min);
  put(surface.box_max, shape.max);
  for (std::size_t i = 0; i < 12; ++i) surface.world_from_object[i] = subject.world_from_object[i / 4][i % 4];
  return surface;
}

TriangleMesh mesh_of_one(const std::array<Point3, 3>& vertices) {
  TriangleMesh mesh;
  mesh.positions.assign(vertices.begin(), vertices.end());
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

}  // namespace

plumb_mesh KernelScene::Mesh::view() const {
  return {positions.data(), positions.size() / 3, triangles.data(), triangles.size() / 3};
}

KernelScene::Mesh KernelScene::flat(const TriangleMesh& mesh) {
  Mesh flat;
  flat.positions.reserve(3 * mesh.positions.size());
  for (const Point3& p : mesh.positions) flat.positions.insert(flat.positions.end(), {p.x, p.y, p.z});
  flat.triangles.reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles)
    flat.triangles.insert(flat.triangles.end(), triangle.begin(), triangle.end());
  return flat;
}

KernelScene::KernelScene(const SubjectScene& scene) {
  std::map<const TriangleMesh*, std::uint32_t> known;
  for (const SubjectSurface& subject : scene) {
    surfaces_.push_back(surface_of(subject));
    const Shape& shape = subject.shape;
    auto next = static_cast<std::uint32_t>(meshes_.size());
    if (shape.kind == ShapeKind::triangle) {
      meshes_.push_back(flat(mesh_of_one(shape.vertices)));
    } else if (shape.kind == ShapeKind::mesh) {
      if (!shape.mesh) throw std::invalid_argument("a mesh without triangles to point to");
      const auto [entry, is_new] = known.try_emplace(shape.mesh.get(), next);
      if (is_new) meshes_.push_back(flat(*shape.mesh));
      next = entry->second;
    } else {
      next = kNoMesh;
    }
    mesh_of_.push_back(next);
  }
  link();
}

void KernelScene::link() {
  for (std::size_t i = 0; i < surfaces_.size(); ++i)
    if (mesh_of_[i] != kNoMesh) surfaces_[i].mesh = meshes_[mesh_of_[i]].view();
}

void KernelScene::write(KernelMessageWriter& message) const {
  message.put<std::uint64_t>(meshes_.size());
  for (const Mesh& mesh : meshes_) {
    message.put<std::uint64_t>(mesh.positions.size());
    message.put<std::uint64_t>(mesh.triangles.size());
    message.put_all(mesh.positions);
    message.put_all(mesh.triangles);
  }
  message.put<std::uint64_t>(surfaces_.size());
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    SurfaceRecord record{};
    copy_numbers(record, surfaces_[i]);
    record.mesh = mesh_of_[i];
    message.put(record);
  }
}

KernelScene KernelScene::read(KernelMessageReader& message) {
  KernelScene scene;
  for (auto left = message.take<std::uint64_t>(); left > 0; --left) {
    const auto positions = message.take<std::uint64_t>();
    const auto triangles = message.take<std::uint64_t>();
    Mesh mesh;
    mesh.positions = message.take_all<double>(positions);
    mesh.triangles = message.take_all<std::uint32_t>(triangles);
    scene.meshes_.push_back(std::move(mesh));
  }
  for (const SurfaceRecord& record : message.take_all<SurfaceRecord>(message.take<std::uint64_t>())) {
    if (record.mesh != kNoMesh && record.mesh >= scene.meshes_.size())
      throw KernelMessageFault("a surface names a mesh that is not there");
    plumb_surface surface{};
    copy_numbers(surface, record);
    scene.surfaces_.push_back(surface);
    scene.mesh_of_.push_back(record.mesh);
  }
  scene.link();
  return scene;
}

KernelRays::KernelRays(std::span<const Ray> rays) : numbers_(kArrays * rays.size()) {
  const std::size_t n = rays.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Ray& ray = rays[i];
    const double of_ray[kArrays] = {ray.origin.x,    ray.origin.y,    ray.origin.z, ray.direction.x,
                                    ray.direction.y, ray.direction.z, ray.t_min,    ray.t_max};
    for (std::size_t k = 0; k < kArrays; ++k) numbers_[k * n + i] = of_ray[k];
  }
}

plumb_rays KernelRays::view(std::size_t begin, std::size_t end) const {
  const auto array = [&](std::size_t k) { return numbers_.data() + k * count() + begin; };
  return {end - begin, array(0), array(1), array(2), array(3), array(4), array(5), array(6), array(7)};
}

void KernelRays::write(KernelMessageWriter& message) const {
  message.put<std::uint64_t>(count());
  message.put_all(numbers_);
}

KernelRays KernelRays::read(KernelMessageReader& message) {
  KernelRays rays;
  const auto count = message.take<std::uint64_t>();
  if (count > SIZE_MAX / kArrays) throw KernelMessageFault("a message holds more rays than can be");
  rays.numbers_ = message.take_all<double>(kArrays * count);
  return rays;
}

}  // namespace plumb

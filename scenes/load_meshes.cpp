#include "scenes/load_meshes.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "meshes/read_mesh.h"
#include "renderer/math/input_error.h"
#include "renderer/math/single_precision.h"

namespace plumb {
namespace {

TriangleMesh in_single_precision(TriangleMesh mesh) {
  for (Point3& p : mesh.positions) p = {rounded_to_single(p.x), rounded_to_single(p.y), rounded_to_single(p.z)};
  for (Normal3& n : mesh.normals) n = {rounded_to_single(n.x), rounded_to_single(n.y), rounded_to_single(n.z)};
  for (TexCoord& c : mesh.texcoords) c = {rounded_to_single(c.u), rounded_to_single(c.v)};
  return mesh;
}

class MeshLoader {
 public:
  explicit MeshLoader(const SceneDescription& scene) : folder_(scene.file.parent_path()) {}

  void visit(const ObjectPointer& object) {
    if (!visited_.insert(object.get()).second) return;
    for (const Property& property : object->properties) {
      if (const auto* child = std::get_if<ObjectPointer>(&property.value)) visit(*child);
      if (property.parameter->type == ValueType::file) load(*object, property.parameter->name);
    }
  }

  MeshTable take() { return std::move(meshes_); }

 private:
  void load(const ObjectDescription& object, std::string_view parameter) {
    const std::string name = object.file_name(parameter);
    if (meshes_.contains(name)) return;
    const std::filesystem::path file = folder_ / name;
    std::error_code error;
    if (!std::filesystem::exists(file, error)) {
      throw InputError(object.where(parameter), "the mesh '" + file.string() +
                                                    "' does not exist, expected a file relative to the scene's folder");
    }
    TriangleMesh mesh = in_single_precision(read_mesh(file));
    if (!std::ranges::all_of(mesh.positions, [](const Point3& p) { return is_finite(p); })) {
      throw InputError(object.where(parameter),
                       "the mesh '" + file.string() +
                           "' has a coordinate beyond the range of single precision, expected at most 3.4e38");
    }
    meshes_.emplace(name, std::make_shared<const TriangleMesh>(std::move(mesh)));
  }

  std::filesystem::path folder_;
  std::set<const ObjectDescription*> visited_;
  MeshTable meshes_;
};

}  // namespace

MeshTable load_meshes(const SceneDescription& scene) {
  MeshLoader loader(scene);
  loader.visit(scene.scene);
  return loader.take();
}

}  // namespace plumb

#include "tools/developer/exact_scene.h"

#include <stdexcept>
#include <string>
#include <utility>

namespace plumb {
namespace {

const SurfaceKind& kind_named(std::string_view name) {
  for (const SurfaceKind* kind : surface_kinds())
    if (kind->kind.name == name) return *kind;
  throw std::logic_error("no surface of kind " + std::string(name));
}

/// An element of a scene file, in memory.
class Element {
 public:
  explicit Element(std::string_view kind) : kind_(kind_named(kind)) { object_.kind = &kind_.kind; }
  Element& with(std::string_view name, Value value) {
    for (const Parameter& parameter : kind_.kind.parameters)
      if (parameter.name == name) object_.properties.push_back({&parameter, std::move(value), {}});
    return *this;
  }
  std::unique_ptr<Surface> make(SurfaceContext& context) const { return kind_.make(object_, context); }

 private:
  const SurfaceKind& kind_;
  ObjectDescription object_;
};

Vec3 as_value(const Point3& p) { return {p.x, p.y, p.z}; }

std::shared_ptr<const TriangleMesh> mesh_of(const Shape& shape) {
  if (shape.kind == ShapeKind::mesh) return shape.mesh;
  TriangleMesh mesh;
  mesh.positions.assign(shape.vertices.begin(), shape.vertices.end());
  mesh.triangles = {{0, 1, 2}};
  return std::make_shared<const TriangleMesh>(std::move(mesh));
}

Element element_of(const Shape& shape) {
  switch (shape.kind) {
    case ShapeKind::sphere:
      return Element("Sphere").with("center", as_value(shape.center)).with("radius", shape.radius);
    case ShapeKind::box:
      return Element("Box").with("minPt", as_value(shape.min)).with("maxPt", as_value(shape.max));
    case ShapeKind::cylinder:
      return Element("Cylinder")
          .with("center", as_value(shape.center))
          .with("radius", shape.radius)
          .with("height", shape.height);
    case ShapeKind::cone:
      return Element("Cone")
          .with("center", as_value(shape.center))
          .with("tipz", shape.tip_z)
          .with("radius", shape.radius)
          .with("height", shape.height);
    case ShapeKind::triangle:
    case ShapeKind::mesh:
      break;
  }
  return Element("Mesh").with("data", std::string("mesh"));
}

}  // namespace

Scene exact_scene(std::span<const PlacedShape> shapes, Accel accel) {
  SceneContents contents;
  std::vector<std::string> warnings;
  for (const PlacedShape& placed : shapes) {
    MeshTable meshes;
    const bool is_mesh = placed.shape.kind == ShapeKind::triangle || placed.shape.kind == ShapeKind::mesh;
    if (is_mesh) meshes["mesh"] = mesh_of(placed.shape);
    SurfaceContext context{meshes, accel, warnings};
    contents.surfaces.push_back(element_of(placed.shape).make(context));
    contents.placed.push_back({contents.surfaces.back().get(), Transform(placed.world_from_object), nullptr});
  }
  return Scene(std::move(contents), accel);
}

}  // namespace plumb

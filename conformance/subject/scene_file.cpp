#include "conformance/subject/scene_file.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>

#include "meshes/formats/write_msh.h"
#include "renderer/image/staged_file.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBegin = R"(<?xml version="1.0" encoding="UTF-8"?>
<scene>
  <camera type="Camera">
    <viewPoint>0 0 10</viewPoint>
    <viewDir>0 0 -1</viewDir>
    <viewUp>0 1 0</viewUp>
    <projDistance>1</projDistance>
    <viewWidth>1</viewWidth>
    <viewHeight>1</viewHeight>
  </camera>
  <image>16 16</image>
  <light>
    <position>5 7 10</position>
    <intensity>1 1 1</intensity>
  </light>
  <shader name="matt" type="Lambertian">
    <diffuseColor>1 1 1</diffuseColor>
  </shader>
)";

std::string number(double value) {
  if (!std::isfinite(value)) throw std::invalid_argument("write_scene_file: a number is not finite");
  return fmt::format("{}", value);
}

template <class Triple>
std::string numbers(const Triple& v) {
  return number(v.x) + ' ' + number(v.y) + ' ' + number(v.z);
}

std::string element(const char* tag, const std::string& text) { return fmt::format("<{0}>{1}</{0}>\n", tag, text); }

class SceneWriter {
 public:
  explicit SceneWriter(fs::path folder) : folder_(std::move(folder)) {}

  void add(const SubjectSurface& surface) {
    if (surface.groups.empty() && surface.world_from_object != identity_matrix())
      throw UnsupportedBySubject("a scene file holds translations, rotations and scales, but no matrix");
    for (const std::vector<TransformStep>& group : surface.groups) {
      text_ += "<surface type=\"Group\">\n";
      for (const TransformStep& step : group) text_ += element(tag(step.kind), numbers(step.value));
    }
    add_shape(surface.shape);
    for (std::size_t i = 0; i < surface.groups.size(); ++i) text_ += "</surface>\n";
  }

  fs::path write() const {
    const fs::path file = folder_ / "scene.xml";
    write_file_staged(file, kBegin + text_ + "</scene>\n");
    return file;
  }

 private:
  static const char* tag(TransformStep::Kind kind) {
    switch (kind) {
      case TransformStep::Kind::translate:
        return "translate";
      case TransformStep::Kind::rotate:
        return "rotate";
      case TransformStep::Kind::scale:
        return "scale";
    }
    throw std::logic_error("unknown kind of a transform's step");
  }

  void add_shape(const Shape& shape) {
    const auto center = [&] { return element("center", numbers(shape.center)); };
    const auto radius = [&] { return element("radius", number(shape.radius)); };
    const auto height = [&] { return element("height", number(shape.height)); };
    switch (shape.kind) {
      case ShapeKind::triangle:
      case ShapeKind::mesh:
        return add_surface("Mesh", element("data", mesh_name(shape)));
      case ShapeKind::sphere:
        return add_surface("Sphere", center() + radius());
      case ShapeKind::box:
        return add_surface("Box", element("minPt", numbers(shape.min)) + element("maxPt", numbers(shape.max)));
      case ShapeKind::cylinder:
        return add_surface("Cylinder", center() + radius() + height());
      case ShapeKind::cone:
        return add_surface("Cone", center() + element("tipz", number(shape.tip_z)) + radius() + height());
    }
  }

  void add_surface(const char* type, const std::string& parameters) {
    fmt::format_to(std::back_inserter(text_), "<surface type=\"{}\">\n<shader ref=\"matt\"/>\n{}</surface>\n", type,
                   parameters);
  }

  std::string mesh_name(const Shape& shape) {
    const std::shared_ptr<const TriangleMesh> mesh = file_mesh(shape);
    if (const auto known = meshes_.find(mesh); known != meshes_.end()) return known->second;
    const std::string name = fmt::format("mesh-{}.msh", meshes_.size());
    write_msh(*mesh, folder_ / name);
    return meshes_.emplace(mesh, name).first->second;
  }

  fs::path folder_;
  std::string text_;
  std::map<std::shared_ptr<const TriangleMesh>, std::string> meshes_;
};

}  // namespace

fs::path write_scene_file(const SubjectScene& scene, const fs::path& folder) {
  SceneWriter writer(folder);
  for (const SubjectSurface& surface : scene) writer.add(surface);
  return writer.write();
}

std::shared_ptr<const TriangleMesh> file_mesh(const Shape& shape) {
  if (shape.kind == ShapeKind::mesh) return shape.mesh;
  if (shape.kind != ShapeKind::triangle) return nullptr;
  TriangleMesh mesh;
  mesh.positions.assign(shape.vertices.begin(), shape.vertices.end());
  mesh.triangles = {{0, 1, 2}};
  return std::make_shared<const TriangleMesh>(std::move(mesh));
}

}  // namespace plumb

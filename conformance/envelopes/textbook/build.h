#pragma once

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "conformance/envelopes/textbook/scene.h"
#include "conformance/envelopes/textbook/textbook.h"
#include "scenes/scene_kind.h"

namespace plumb::textbook {

/// A number in [-1, 1] that depends on these three alone, by a mixing of bits [Steele 2014].
inline double noise(std::uint64_t surface, std::uint64_t vertex, std::uint64_t axis) {
  std::uint64_t bits = 0x9e3779b97f4a7c15 * (4 * (surface << 32 | vertex) + axis + 1);
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
  return static_cast<double>((bits ^ (bits >> 31)) >> 11) * 0x1p-52 - 1;
}

/// Turns a description into a scene in the arithmetic of A.
template <class A>
class SceneBuilder {
  using Real = RealOf<A>;
  using V = Vector<A>;

 public:
  SceneBuilder(const SceneDescription& description, const MeshTable& meshes, const TextbookOptions& options)
      : description_(*description.scene), mesh_files_(meshes), options_(options) {}

  Scene<A> build() {
    if (options_.other_formulas) scene_.formulas = Formulas::other;
    if (const ObjectPointer camera = description_.object("camera")) scene_.camera = camera_of(*camera);
    for (const ObjectPointer& light : description_.objects("light"))
      scene_.lights.push_back({V::from(light->point("position")), V::from(light->color("intensity"))});
    scene_.shaders.emplace_back();  // number 0, of surfaces without one
    for (const ObjectPointer& surface : description_.objects("surface")) place(*surface, Frame{{}, 0});
    build_hierarchy();
    return std::move(scene_);
  }

 private:
  /// What the groups around a surface say: transforms, the first outermost, and the number of a shader.
  struct Frame {
    std::vector<Matrix<A>> world_from_group;
    std::size_t shader;
  };

  static Camera<A> camera_of(const ObjectDescription& camera) {
    const V view = unit(V::from(camera.vector("viewDir")));
    const V normal = unit(V::from(camera.vector(camera.has("projNormal") ? "projNormal" : "viewDir")));
    const V w = dot(normal, view) > 0 ? -normal : normal;
    const V u = unit(cross(unit(V::from(camera.vector("viewUp"))), w));
    const V v = cross(w, u);
    return {V::from(camera.point("viewPoint")), real(camera.number("projDistance")) * view,
            real(camera.number("viewWidth")) * u, real(camera.number("viewHeight")) * v};
  }

  static Real real(double x) { return static_cast<Real>(x); }

  std::size_t shader_of(const ObjectPointer& object) {
    if (const auto known = shaders_.find(object.get()); known != shaders_.end()) return known->second;
    Shader<A> shader;
    const std::string_view kind = object->kind->name;
    if (kind != "Lambertian" && kind != "Phong" && kind != "Glazed" && kind != "Glass")
      throw std::logic_error("the textbook tracer has no shader of kind " + std::string(kind));
    if (kind == "Lambertian" || kind == "Phong") shader.diffuse = V::from(object->color("diffuseColor"));
    if (kind == "Phong") {
      shader.coat = Coat::phong;
      shader.specular = V::from(object->color("specularColor"));
      shader.exponent = real(object->number("exponent"));
    }
    if (kind == "Glazed" || kind == "Glass") {
      shader.coat = kind == "Glass" ? Coat::glass : Coat::glazed;
      shader.refractive_index = real(object->number("refractiveIndex"));
    }
    if (kind == "Glazed") shader.substrate = shader_of(object->object("substrate"));
    scene_.shaders.push_back(shader);
    return shaders_[object.get()] = scene_.shaders.size() - 1;
  }

  void place(const ObjectDescription& surface, const Frame& around) {
    Frame frame = around;
    if (const ObjectPointer shader = surface.object("shader")) frame.shader = shader_of(shader);
    if (surface.kind == &group_kind) {
      for (const Property& property : surface.properties) add_transform(property, frame.world_from_group);
      for (const ObjectPointer& member : surface.objects("surface")) place(*member, frame);
      return;
    }
    Placement<A> placed;
    placed.is_mesh = surface.kind->name == "Mesh";
    placed.shape = placed.is_mesh ? mesh_of(surface) : solid_of(surface);
    placed.shader = frame.shader;
    for (const Matrix<A>& step : frame.world_from_group) placed.world_from_object = placed.world_from_object * step;
    if (options_.other_formulas) {
      for (const Matrix<A>& step : frame.world_from_group) placed.object_from_world.push_back(step.inverse());
    } else if (!frame.world_from_group.empty()) {
      placed.object_from_world.push_back(placed.world_from_object.inverse());
    }
    for (const Matrix<A>& step : placed.object_from_world) {
      if (!step.is_finite())
        throw InputError(surface.where(),
                         "its transform has no inverse in the textbook tracer's arithmetic, "
                         "expected factors of scale that are not zero nor extreme");
    }
    scene_.placements.push_back(std::move(placed));
    add_primitives();
  }

  void add_transform(const Property& property, std::vector<Matrix<A>>& steps) const {
    const std::string_view name = property.parameter->name;
    if (name != "translate" && name != "rotate" && name != "scale") return;
    const Vec3 by = std::get<Vec3>(property.value);
    if (name == "translate") steps.push_back(Matrix<A>::translation(V::from(by)));
    if (name == "scale") steps.push_back(Matrix<A>::scaling(V::from(by)));
    if (name != "rotate") return;
    steps.push_back(Matrix<A>::rotation(2, by.z));
    steps.push_back(Matrix<A>::rotation(1, by.y));
    steps.push_back(Matrix<A>::rotation(0, by.x));
  }

  /// The numbers of a point as options_.vertex_noise says.
  template <class Triple>
  V perturbed(const Triple& p, std::size_t surface, std::size_t vertex) const {
    return V::from(Vec3{perturbed(p.x, surface, vertex, 0), perturbed(p.y, surface, vertex, 1),
                        perturbed(p.z, surface, vertex, 2)});
  }
  double perturbed(double x, std::size_t surface, std::size_t vertex, std::size_t axis) const {
    return x * (1 + options_.vertex_noise * noise(surface, vertex, axis));
  }

  std::size_t solid_of(const ObjectDescription& object) {
    const auto [known, is_new] = solids_.try_emplace(&object, scene_.solids.size());
    const std::size_t number = known->second;
    if (!is_new) return number;
    Solid<A> solid;
    const std::string_view kind = object.kind->name;
    if (kind == "Box") {
      // One factor an axis, so that no box is turned inside out.
      const Point3 min = object.point("minPt"), max = object.point("maxPt");
      solid.min = perturbed(min, number, 0), solid.max = perturbed(max, number, 0);
      solid.shape = min.x <= max.x && min.y <= max.y && min.z <= max.z ? Shape::box : Shape::inverted_box;
    } else {
      solid.shape = kind == "Sphere" ? Shape::sphere : kind == "Cylinder" ? Shape::cylinder : Shape::cone;
      if (kind != "Sphere" && kind != "Cylinder" && kind != "Cone")
        throw std::logic_error("the textbook tracer has no surface of kind " + std::string(kind));
      solid.center = perturbed(object.point("center"), number, 0);
      solid.radius = real(perturbed(object.number("radius"), number, 0, 3));
    }
    if (kind == "Cylinder" || kind == "Cone")
      solid.half_height = real(perturbed(object.number("height") / 2, number, 1, 0));
    if (kind == "Cone") solid.tip_z = real(perturbed(object.number("tipz"), number, 0, 2));
    scene_.solids.push_back(solid);
    return number;
  }

  std::size_t mesh_of(const ObjectDescription& object) {
    const auto [known, is_new] = meshes_.try_emplace(object.file_name("data"), scene_.meshes.size());
    if (!is_new) return known->second;
    const TriangleMesh& from = *mesh_files_.at(known->first);
    Mesh<A> mesh;
    mesh.triangles = from.triangles;
    for (std::size_t i = 0; i < from.positions.size(); ++i)
      mesh.positions.push_back(perturbed(from.positions[i], known->second, i));
    for (const Normal3& normal : from.normals) mesh.normals.push_back(V::from(normal));
    scene_.meshes.push_back(std::move(mesh));
    return known->second;
  }

  Bounds<A> bounds_of(const Solid<A>& solid) const {
    Bounds<A> bounds;
    if (solid.shape == Shape::box || solid.shape == Shape::inverted_box) {
      bounds.extend(solid.min), bounds.extend(solid.max);
      return bounds;
    }
    Real radius = solid.radius, height = solid.shape == Shape::sphere ? solid.radius : solid.half_height;
    if (solid.shape == Shape::cone)
      radius = solid.slope() * (std::fabs(solid.center.z - solid.tip_z) + solid.half_height);
    bounds.extend(solid.center - V{radius, radius, height}), bounds.extend(solid.center + V{radius, radius, height});
    return bounds;
  }

  void add_primitives() {
    const Placement<A>& placed = scene_.placements.back();
    const Matrix<A>& world_from_object = placed.world_from_object;
    const auto number = static_cast<std::uint32_t>(scene_.placements.size() - 1);
    if (placed.is_mesh) {
      const Mesh<A>& mesh = scene_.meshes[placed.shape];
      for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        Bounds<A> bounds;
        for (const std::uint32_t vertex : mesh.triangles[i])
          bounds.extend(world_from_object.move(mesh.positions[vertex]));
        scene_.primitives.push_back({number, i});
        bounds_.push_back(bounds);
      }
      return;
    }
    const Bounds<A> local = bounds_of(scene_.solids[placed.shape]);
    Bounds<A> bounds;
    for (int corner = 0; corner < 8; ++corner) {
      bounds.extend(
          world_from_object.move({corner & 1 ? local.max.x : local.min.x, corner & 2 ? local.max.y : local.min.y,
                                  corner & 4 ? local.max.z : local.min.z}));
    }
    scene_.primitives.push_back({number, 0});
    bounds_.push_back(bounds);
  }

  /// Boxes are widened for what is rounded in them, in a ray's origin and on the way into an object's frame: a few
  /// dozen units of the last place of the largest coordinate around.
  void build_hierarchy() {
    Bounds<A> all;
    all.extend(scene_.camera.eye);
    for (const Bounds<A>& bounds : bounds_) all.extend(bounds);
    Real largest = 0;
    for (const V& corner : {all.min, all.max})
      for (std::size_t axis = 0; axis < 3; ++axis) largest = std::max(largest, std::fabs(corner[axis]));
    for (Bounds<A>& bounds : bounds_) bounds = bounds.widened(64 * std::numeric_limits<Real>::epsilon() * largest);
    scene_.hierarchy = Hierarchy<A>(bounds_);
  }

  const ObjectDescription& description_;
  const MeshTable& mesh_files_;
  const TextbookOptions& options_;
  Scene<A> scene_;
  std::vector<Bounds<A>> bounds_;
  std::map<const ObjectDescription*, std::size_t> shaders_, solids_;
  std::map<std::string, std::size_t> meshes_;
};

}  // namespace plumb::textbook

#include "renderer/build_scene.h"

#include <map>
#include <stdexcept>

#include "renderer/film/tiles.h"
#include "renderer/math/affine_product.h"
#include "renderer/math/input_error.h"
#include "scenes/scene_kind.h"

namespace plumb {
namespace {

/// The entry of a table of kinds that a description was parsed by.
template <class KindEntry>
const KindEntry& entry_of(std::span<const KindEntry* const> kinds, const ObjectDescription& object) {
  for (const KindEntry* entry : kinds)
    if (&entry->kind == object.kind) return *entry;
  throw std::logic_error("the kind " + std::string(object.kind->name) + " is not in its table");
}

/// Substrates under substrates are shaded recursively.
constexpr int kDeepestShader = 1000;

class SceneBuilder {
 public:
  SceneBuilder(const SceneDescription& description, const MeshTable& meshes, const BuildOptions& options,
               std::vector<std::string>& warnings)
      : description_(*description.scene),
        options_(options),
        context_{meshes, options.accel, warnings, thread_count(options.threads)} {}

  Scene build() {
    const SceneOverrides& overrides = options_.overrides;
    contents_.image_size = overrides.image_size.value_or(description_.size("image"));
    contents_.samples = overrides.samples.value_or(description_.integer("samples"));
    contents_.max_depth = overrides.max_depth.value_or(description_.integer("maxDepth"));
    contents_.min_contribution = overrides.min_contribution.value_or(description_.number("minContribution"));
    contents_.fresnel = options_.fresnel;
    contents_.camera = make_camera();
    for (const ObjectPointer& light : description_.objects("light"))
      contents_.lights.push_back(entry_of(light_kinds(), *light).make(*light));
    for (const ObjectPointer& shader : description_.objects("shader")) shader_of(*shader);
    for (const ObjectPointer& surface : description_.objects("surface")) place(*surface, Placement{{}, nullptr});
    return Scene(std::move(contents_), options_.accel);
  }

 private:
  /// What the groups around a surface say of it.
  struct Placement {
    AffineProduct world_from_group;
    const ObjectDescription* shader;
  };

  std::unique_ptr<Camera> make_camera() const {
    if (const ObjectPointer camera = description_.object("camera"))
      return entry_of(camera_kinds(), *camera).make(*camera);
    ObjectDescription defaults;
    defaults.kind = &camera_kinds().front()->kind;
    defaults.file = description_.file;
    defaults.position = description_.position;
    return camera_kinds().front()->make(defaults);
  }

  void place(const ObjectDescription& surface, const Placement& around) {
    if (++visits_ > kMostPlacedSurfaces) {  // groups count too: shared ones multiply even where they hold nothing
      throw InputError(surface.where(), "more than " + std::to_string(kMostPlacedSurfaces) +
                                            " surfaces and groups, counting each use of a shared one");
    }
    if (surface.kind == &group_kind) {
      place_group(surface, around);
      return;
    }
    const ObjectPointer own_shader = surface.object("shader");
    const ObjectDescription* shader = own_shader ? own_shader.get() : around.shader;
    contents_.placed.push_back({&surface_of(surface), transform(surface, around.world_from_group.rounded()),
                                shader ? &shader_of(*shader) : &white()});
  }

  /// Transforms multiply in file order, the first outermost, and apply to all members wherever they stand.
  void place_group(const ObjectDescription& group, const Placement& around) {
    Placement inner = around;
    for (const Property& property : group.properties) {
      const std::string_view name = property.parameter->name;
      if (name == "translate") inner.world_from_group.translate(std::get<Vec3>(property.value));
      if (name == "rotate") inner.world_from_group.rotate_degrees(std::get<Vec3>(property.value));
      if (name == "scale") inner.world_from_group.scale(factors(group, property));
    }
    transform(group, inner.world_from_group.rounded());  // a singular one is the group's fault, not its members'
    const ObjectPointer shader = group.object("shader");
    if (shader) inner.shader = shader.get();
    for (const ObjectPointer& member : group.objects("surface")) place(*member, inner);
  }

  /// A factor of zero is refused here: rounding can hide it in a product with rotations.
  static Vec3 factors(const ObjectDescription& group, const Property& scale) {
    const Vec3 factors = std::get<Vec3>(scale.value);
    if (factors.x == 0 || factors.y == 0 || factors.z == 0) {
      throw InputError({*group.file, scale.where.line, scale.where.column},
                       "the transform is singular: <scale> has a factor of zero, which flattens space");
    }
    return factors;
  }

  static Transform transform(const ObjectDescription& object, const AffineMatrix& matrix) {
    try {
      return Transform(matrix);
    } catch (const SingularTransform& error) {
      throw InputError(object.where(), std::string(error.what()) + ", expected factors of scale that are not zero");
    }
  }

  const Surface& surface_of(const ObjectDescription& object) {
    const auto [entry, is_new] = surfaces_.try_emplace(&object, nullptr);
    if (is_new) {
      contents_.surfaces.push_back(entry_of(surface_kinds(), object).make(object, context_));
      entry->second = contents_.surfaces.back().get();
    }
    return *entry->second;
  }

  const Shader& shader_of(const ObjectDescription& object) {
    if (const auto known = shaders_.find(&object); known != shaders_.end()) return *known->second;
    if (++shader_depth_ > kDeepestShader)
      throw InputError(object.where(),
                       "shaders lie in each other more than " + std::to_string(kDeepestShader) + " deep");
    auto shader =
        entry_of(shader_kinds(), object).make(object, [this](const ObjectDescription& inner) -> const Shader& {
          return shader_of(inner);
        });
    --shader_depth_;
    contents_.shaders.push_back(std::move(shader));
    return *shaders_.emplace(&object, contents_.shaders.back().get()).first->second;
  }

  /// What a surface without any shader gets: Lambertian, whose default is white.
  const Shader& white() {
    if (!white_.kind) {
      for (const ShaderKind* entry : shader_kinds())
        if (entry->kind.name == "Lambertian") white_.kind = &entry->kind;
    }
    return shader_of(white_);
  }

  const ObjectDescription& description_;
  const BuildOptions& options_;
  SurfaceContext context_;
  SceneContents contents_;
  std::size_t visits_ = 0;
  int shader_depth_ = 0;
  std::map<const ObjectDescription*, const Surface*> surfaces_;
  std::map<const ObjectDescription*, const Shader*> shaders_;
  ObjectDescription white_;
};

}  // namespace

Scene build_scene(const SceneDescription& description, const MeshTable& meshes, const BuildOptions& options,
                  std::vector<std::string>& warnings) {
  return SceneBuilder(description, meshes, options, warnings).build();
}

}  // namespace plumb

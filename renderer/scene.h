#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "renderer/accel/accelerator.h"
#include "renderer/cameras/camera.h"
#include "renderer/lights/light.h"
#include "renderer/shaders/fresnel.h"
#include "renderer/shaders/shader.h"
#include "renderer/surfaces/surface.h"
#include "scenes/value.h"

namespace plumb {

/// One occurrence of a surface. The surface and the shader may be shared with other occurrences.
struct PlacedSurface {
  const Surface* surface;
  Transform world_from_object;
  const Shader* shader;
};

/// What a scene is made of.
struct SceneContents {
  std::vector<std::unique_ptr<Surface>> surfaces;
  std::vector<std::unique_ptr<Shader>> shaders;
  std::vector<std::unique_ptr<Light>> lights;
  std::unique_ptr<Camera> camera;
  /// In file order, which decides ties.
  std::vector<PlacedSurface> placed;
  Size2 image_size;
  int samples = 1;
  int max_depth = 12;
  double min_contribution = 0.01;
  Fresnel fresnel = Fresnel::exact;
};

/// A scene that is ready to be traced. Immutable, so any number of threads may trace it.
class Scene {
 public:
  Scene(SceneContents contents, Accel accel);

  /// A hit with the surface it is on.
  struct Hit {
    SurfaceHit hit;
    std::uint32_t placed;
  };

  /// The hit with the smallest t in the ray's closed range; of equal ones the surface first in file order, then the
  /// lowest part. For triangles range and order are those of the exact t of the ray as given, against solids rounded to
  /// nearest; solids have the t that they report. t is the ray's own parameter, whatever transforms lie between.
  std::optional<Hit> closest_hit(const Ray& ray, TraceCounters& counters) const;
  /// Whether any surface lies within the ray's range.
  bool blocks(const Ray& ray, TraceCounters& counters) const;
  /// Position, unit normal and view direction of a hit that closest_hit found for this ray, in world space.
  ShadingPoint shading_point(const Ray& ray, const Hit& hit) const;

  const Shader& shader(const Hit& hit) const { return *contents_.placed[hit.placed].shader; }
  const std::vector<PlacedSurface>& placed() const { return contents_.placed; }
  const std::vector<std::unique_ptr<Light>>& lights() const { return contents_.lights; }
  const Camera& camera() const { return *contents_.camera; }
  Size2 image_size() const { return contents_.image_size; }
  int samples() const { return contents_.samples; }
  int max_depth() const { return contents_.max_depth; }
  double min_contribution() const { return contents_.min_contribution; }
  Fresnel fresnel() const { return contents_.fresnel; }

 private:
  SceneContents contents_;
  Accelerator accelerator_;
};

}  // namespace plumb

#pragma once

#include <functional>
#include <memory>
#include <span>

#include "renderer/math/vec3.h"
#include "scenes/object_description.h"

namespace plumb {

class Tracer;

/// The point that a ray has found, in world space.
struct ShadingPoint {
  Point3 position;
  /// Of unit length, to the outside of the surface.
  Normal3 normal;
  /// Of unit length, back along the ray.
  Vec3 to_viewer;
};

/// How a ray came about: the depth of the ray (a camera ray has 1) and the share of its pixel that it counts for.
struct Path {
  int depth = 1;
  double contribution = 1;
};

/// What a surface looks like. Const and safe to use from any number of threads.
class Shader {
 public:
  virtual ~Shader() = default;
  /// The light that leaves the point towards the viewer, linear. Rays it needs go through `tracer`.
  virtual Color shade(const ShadingPoint& point, const Path& path, Tracer& tracer) const = 0;
};

/// Gives the shader of a description, which may be shared (a glaze's substrate).
using ShaderOf = std::function<const Shader&(const ObjectDescription&)>;

/// A kind of shader: its parameter table and how one is made.
struct ShaderKind {
  Kind kind;
  std::unique_ptr<Shader> (*make)(const ObjectDescription&, const ShaderOf&);
};

/// Every kind, sorted by file name.
std::span<const ShaderKind* const> shader_kinds();

}  // namespace plumb

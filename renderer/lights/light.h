#pragma once

#include <memory>
#include <span>

#include "renderer/math/vec3.h"
#include "scenes/object_description.h"

namespace plumb {

/// A light as one point sees it.
struct LightSample {
  /// From the point to the light; not of unit length: the light is at t = 1.
  Vec3 to_light;
  /// What arrives where nothing is in the way.
  Color intensity;
};

/// Const and safe to use from any number of threads.
class Light {
 public:
  virtual ~Light() = default;
  virtual LightSample sample(const Point3& point) const = 0;
};

/// A kind of light: its parameter table and how one is made.
struct LightKind {
  Kind kind;
  std::unique_ptr<Light> (*make)(const ObjectDescription&);
};

/// Every kind, sorted by file name.
std::span<const LightKind* const> light_kinds();

}  // namespace plumb

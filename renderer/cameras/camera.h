#pragma once

#include <memory>
#include <span>

#include "renderer/math/ray.h"
#include "scenes/object_description.h"

namespace plumb {

/// Const and safe to use from any number of threads.
class Camera {
 public:
  virtual ~Camera() = default;
  /// The ray, in world space, through a place of the view window: u from 0 at its left edge to 1 at its right, v from
  /// 0 at its bottom to 1 at its top.
  virtual Ray ray(double u, double v) const = 0;
};

/// A kind of camera: its parameter table and how one is made. Making throws InputError at the parameter at fault.
struct CameraKind {
  Kind kind;
  std::unique_ptr<Camera> (*make)(const ObjectDescription&);
};

/// Every kind, sorted by file name.
std::span<const CameraKind* const> camera_kinds();

}  // namespace plumb

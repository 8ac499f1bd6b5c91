#pragma once

#include <span>
#include <vector>

#include "reference/shape.h"
#include "renderer/scene.h"

namespace plumb {

/// The oracle's shapes as the renderer's surfaces, in this order; a triangle is a mesh of one. Throws InputError or
/// SingularTransform where the renderer takes no such surface.
Scene exact_scene(std::span<const PlacedShape> shapes, Accel accel);

}  // namespace plumb

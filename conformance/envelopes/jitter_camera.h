#pragma once

#include <cstdint>

#include "renderer/scene.h"
#include "scenes/moved_camera.h"
#include "scenes/scene_description.h"

namespace plumb {

/// Another place for the camera, drawn from the seed: it swings by up to 4 degrees about what the middle of the picture
/// shows (the median distance of the first hits of an 8 x 8 grid of rays), about a random axis, and with it viewUp and
/// projNormal. `view` numbers the places of one scene, from 1. No function of libm but sqrt: the same on every machine.
/// Where no ray of the grid hits anything it swings about the point at distance 1.
CameraPlace jittered_camera(const SceneDescription& description, const Scene& scene, std::uint64_t seed, int view);

}  // namespace plumb

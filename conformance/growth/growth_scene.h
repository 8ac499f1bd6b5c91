#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "conformance/growth/growth_gate.h"
#include "conformance/growth/growth_mesh.h"
#include "renderer/math/vec3.h"

namespace plumb {

/// Where the picture is taken from, in world space. The window is that of a projection plane at distance 1.
struct GrowthCamera {
  Point3 eye;
  Vec3 direction, up;
  double view_width = 0, view_height = 0;
};

/// A camera that sees most of the cube from -1 to 1, drawn anew for each round: from anywhere in between the axes, or
/// from near a random axis exactly along it. All numbers are multiples of 2^-12.
GrowthCamera growth_camera(GrowthView view, int round, std::uint64_t seed);

/// What a template's placeholders stand for: `{width}`, ... without their braces.
using GrowthNames = std::map<std::string, std::string, std::less<>>;

/// `width`, `height`, `eye`, `direction`, `up` ("x y z", and `eye_x` and so on), `view_width`, `view_height`.
GrowthNames camera_names(const GrowthCamera& camera, int width, int height);

/// `center` ("x y z"), `x`, `y`, `z`, `radius`.
GrowthNames ball_names(const GrowthBall& ball);

/// The text with each `{name}` that is known replaced; any other brace stands for itself.
std::string filled_template(std::string_view text, const GrowthNames& names);

}  // namespace plumb

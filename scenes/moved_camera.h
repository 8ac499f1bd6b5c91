#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "renderer/math/vec3.h"

namespace plumb {

/// Where a camera stands and looks; directions of any length.
struct CameraPlace {
  Point3 view_point;
  Vec3 view_dir;
  Vec3 view_up;
  /// Nothing where it is that of view_dir.
  std::optional<Vec3> proj_normal;
};

/// The scene file's text with its camera moved: the values of the place are written with 17 digits, in place of
/// those that were there (names regardless of case), or in a new `camera` element where there is none; all the rest
/// stays as it was. Throws InputError for a file that is no XML, several cameras, or one that is a `ref`.
std::string scene_with_camera(const std::filesystem::path& scene, const CameraPlace& place);

}  // namespace plumb

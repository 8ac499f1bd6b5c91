#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenes/object_description.h"

namespace plumb {

/// A scene file as it was parsed: values and where they stood, nothing built.
struct SceneDescription {
  /// The file; meshes resolve against its folder.
  std::filesystem::path file;
  /// The root, of kind scene_kind.
  ObjectPointer scene;
  /// One line each, `file:line:column: warning: ...`.
  std::vector<std::string> warnings;
};

}  // namespace plumb

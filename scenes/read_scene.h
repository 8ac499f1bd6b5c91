#pragma once

#include <filesystem>

#include "scenes/kind.h"
#include "scenes/scene_description.h"

namespace plumb {

/// Reads a scene file by the parameter tables of `kinds` (scene_kind and group_kind are always known).
/// Nothing else is opened: meshes are only named.
///
/// Tags match regardless of case. `type` names a kind, with or without a package before it. `ref` stands for
/// an element that was given a `name` earlier and shares it. A single-valued tag given twice: the last wins,
/// with a warning. Throws InputError, with line and column, for malformed XML, an unknown tag, attribute, type
/// or reference (naming the nearest known one), a wrong count of numbers or one out of range, a missing
/// required tag, text where elements belong, an absurd picture size, and nesting past 1000 levels.
SceneDescription read_scene(const std::filesystem::path& file, const KindTable& kinds);

}  // namespace plumb

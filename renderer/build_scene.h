#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/scene.h"
#include "scenes/load_meshes.h"
#include "scenes/scene_description.h"

namespace plumb {

/// What a command line may say in place of the scene.
struct SceneOverrides {
  std::optional<Size2> image_size;
  std::optional<int> samples;
  std::optional<int> max_depth;
  std::optional<double> min_contribution;
};

struct BuildOptions {
  SceneOverrides overrides;
  Fresnel fresnel = Fresnel::exact;
  Accel accel = Accel::bvh8;
  /// How many may build; 0 for as many as there are processors. Nothing that is found depends on it.
  int threads = 0;
};

/// Makes a scene ready to trace. A surface that is referred to from several places is made once, and
/// so is the hierarchy of a mesh that several surfaces name. Throws InputError, at
/// the element at fault, for a singular transform, a camera without a direction and the like, and for more than
/// kMostPlacedSurfaces surfaces and groups, each use of a shared one counted. Warnings are appended, one line each.
Scene build_scene(const SceneDescription& description, const MeshTable& meshes, const BuildOptions& options,
                  std::vector<std::string>& warnings);

constexpr std::size_t kMostPlacedSurfaces = 10'000'000;

}  // namespace plumb

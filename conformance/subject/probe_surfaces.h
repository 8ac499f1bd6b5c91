#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "conformance/subject/subject.h"

namespace plumb {

/// Where a surface of a program's own list stands in the scene that it was given.
struct ProbePlace {
  std::uint32_t surface = 0;
  /// The triangle of that surface's mesh, where the program lists its triangles one by one.
  std::optional<std::uint32_t> triangle;
  /// Of a mesh that is listed whole: how many triangles it has.
  std::optional<std::uint32_t> triangles;
};

/// Finds for each surface that a program lists the place in the scene, which was written by write_scene_file: by path,
/// type and numbers, or by type and numbers where the list has no paths; equal ones in their order. A mesh is listed as
/// it is or by its triangles. Numbers must be those of the scene exactly, in the contract's precision.
///
/// Throws SubjectFailure: fail with `protocol` for a list that is none, with `surfaces`, naming the difference, where
/// it is not the scene's.
std::vector<ProbePlace> match_surfaces(const nlohmann::json& list, const SubjectScene& scene, const Contract& contract);

}  // namespace plumb

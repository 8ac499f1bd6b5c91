#pragma once

#include <filesystem>
#include <memory>

#include "conformance/subject/subject.h"
#include "meshes/triangle_mesh.h"

namespace plumb {

/// Writes the scene as `scene.xml` (docs/scene-format.md) with its meshes beside it into an existing folder, and
/// returns the file's path. The n-th surface is the n-th `<surface>` of the scene, within a `Group` of its own for each
/// of its groups, so its path is "n/0/0...". Numbers are the shortest decimals that read back to the same bits, 17
/// digits at most. A single triangle becomes a mesh of one; a mesh that several surfaces share is one file. Camera,
/// light and shader are there to make the file complete: from (0, 0, 10) along -z, 16 by 16 pixels.
///
/// Throws UnsupportedBySubject for a matrix that no groups make, which such a file cannot hold; std::invalid_argument
/// for numbers that are not finite; InputError if a file cannot be written.
std::filesystem::path write_scene_file(const SubjectScene& scene, const std::filesystem::path& folder);

/// The surface's mesh as it stands in the file: its own, or that of the single triangle; null for other shapes.
std::shared_ptr<const TriangleMesh> file_mesh(const Shape& shape);

}  // namespace plumb

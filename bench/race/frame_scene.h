#pragma once

#include <filesystem>

#include "meshes/triangle_mesh.h"

namespace plumb::bench {

/// Writes the same picture for both programs: a matt mesh with flat facets, seen by a pinhole camera that looks at it
/// from in front and above, 640 x 480, one point light without falloff, with shadows. In `folder`: mesh.msh (text) and
/// scene.xml for plumb, scene.pov (a mesh2) for POV-Ray. Both numbers are decimal and read back the same.
void write_frame_scene(const TriangleMesh& mesh, const std::filesystem::path& folder);

}  // namespace plumb::bench

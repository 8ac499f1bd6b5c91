#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "meshes/triangle_mesh.h"

namespace plumb::bench {

/// The meshes of the race, as far as they are there: bunny69k and igea268k are files of the shared data, city380k
/// (beams) and knot1500k (a torus knot) are generated.
std::vector<std::string> race_mesh_names();

/// The mesh of that name without its normals and texture coordinates, each coordinate rounded to float. Throws
/// InputError where its file cannot be read.
std::shared_ptr<const TriangleMesh> race_mesh(std::string_view name);

/// The torus knot with at least so many triangles (32 n^2), rounded likewise.
std::shared_ptr<const TriangleMesh> knot_mesh(std::size_t triangles);

}  // namespace plumb::bench

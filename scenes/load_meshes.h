#pragma once

#include <map>
#include <memory>
#include <string>

#include "meshes/triangle_mesh.h"
#include "scenes/scene_description.h"

namespace plumb {

/// The meshes that a scene names, by the name as it is written there.
using MeshTable = std::map<std::string, std::shared_ptr<const TriangleMesh>>;

/// Reads every mesh file that a surface of the scene names, each once, relative to the scene's folder. Its numbers are
/// rounded to single precision, as the course's framework stores them: with doubles, single pixels of the course's
/// pictures (bunny500, bunny500_norms_aa) come out one level off.
/// A file that does not exist is an InputError at the element that names it; one that cannot be parsed, at its
/// own line.
MeshTable load_meshes(const SceneDescription& scene);

}  // namespace plumb

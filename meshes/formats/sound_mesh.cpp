#include "meshes/formats/sound_mesh.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plumb {

void require_sound(const TriangleMesh& mesh) {
  const std::size_t vertices = mesh.positions.size();
  if (!mesh.normals.empty() && mesh.normals.size() != vertices)
    throw std::invalid_argument("normals must be one a vertex");
  if (!mesh.texcoords.empty() && mesh.texcoords.size() != vertices) {
    throw std::invalid_argument("texcoords must be one a vertex");
  }
  const bool finite = std::all_of(mesh.positions.begin(), mesh.positions.end(), is_finite<Point3>) &&
                      std::all_of(mesh.normals.begin(), mesh.normals.end(), is_finite<Normal3>) &&
                      std::all_of(mesh.texcoords.begin(), mesh.texcoords.end(),
                                  [](const TexCoord& t) { return std::isfinite(t.u) && std::isfinite(t.v); });
  if (!finite) throw std::invalid_argument("a number of the mesh is not finite");
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t index : triangle) {
      if (index >= vertices) throw std::invalid_argument("a vertex index of the mesh is out of range");
    }
  }
}

}  // namespace plumb

#pragma once

#include <cstdint>
#include <functional>

#include "meshes/triangle_mesh.h"

namespace plumb {

/// A regular icosahedron on the unit sphere around the origin whose faces are cut in four `subdivisions`
/// times, the new vertices pushed out to the sphere: 20 * 4^n faces and 10 * 4^n + 2 vertices, none twice.
/// Front sides face outward; normals equal positions, which have unit length within 2 ulp. Only + - * / and
/// sqrt are used, so it has the same bits on every machine. Throws std::invalid_argument unless
/// 0 <= subdivisions <= 10. `progress`, which may be empty, is told the share that is done.
TriangleMesh icosphere(int subdivisions, const std::function<void(double)>& progress = {});

/// The subdivisions after which an icosphere has at least so many triangles. Throws InputError if it takes more
/// than 10.
int icosphere_subdivisions(std::uint64_t triangles);

}  // namespace plumb

#pragma once

#include "meshes/triangle_mesh.h"

namespace plumb {

/// A regular icosahedron on the unit sphere around the origin whose faces are cut in four `subdivisions`
/// times, the new vertices pushed out to the sphere: 20 * 4^n faces and 10 * 4^n + 2 vertices, none twice.
/// Front sides face outward; normals equal positions, which have unit length within 2 ulp. Only + - * / and
/// sqrt are used, so it has the same bits on every machine. Throws std::invalid_argument unless
/// 0 <= subdivisions <= 10.
TriangleMesh icosphere(int subdivisions);

}  // namespace plumb

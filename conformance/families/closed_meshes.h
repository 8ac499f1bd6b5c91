#pragma once

#include <string>
#include <vector>

#include "conformance/families/recipe.h"

namespace plumb {

/// A surface that encloses a place: whatever a ray does that begins inside, it meets it. A miss is a leak, and there is
/// no excuse by rounding.
struct ClosedSurface {
  std::string name;
  SubjectSurface surface;
};

/// Closed meshes, each edge between two triangles in opposite directions, seen whole from their middle: icospheres of
/// 80, 320 and 1280 faces, lattice cubes (whole coordinates, faces of n x n squares), a needle of a box, cubes and
/// icospheres 1e3 to 1e7 away from zero, a bumpy sphere. In world space (no groups). All numbers representable.
std::vector<ClosedSurface> closed_meshes(plumb_precision precision);
/// Capped solids as they stand: sphere, box, cylinder, cone, double cone; flat and long ones too.
std::vector<ClosedSurface> closed_solids(plumb_precision precision);
/// The surfaces in nested, sheared, mirrored and far groups, whose rounded product is their matrix.
std::vector<ClosedSurface> under_matrices(const std::vector<ClosedSurface>& surfaces, plumb_precision precision);

/// Rays that begin strictly inside, aimed at vertices, edges and faces in turn (of solids: at rims, edges and corners,
/// and elsewhere on the surface), t_min 0, without an end. In a mesh of whole numbers every second origin is whole, so
/// that its rays meet vertices exactly. The n-th ray depends on the surface, the seed and n alone.
std::vector<Ray> leak_rays(const ClosedSurface& closed, std::uint64_t seed, std::size_t count,
                           plumb_precision precision);

/// A vertex, a point of an edge or of a face of the mesh, drawn evenly by kind; the last two up to rounding.
Point3 mesh_point(Random& random, const TriangleMesh& mesh);
/// The middle of the box around the vertices.
Point3 middle_of(const TriangleMesh& mesh);

}  // namespace plumb

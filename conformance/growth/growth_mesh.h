#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "meshes/triangle_mesh.h"

namespace plumb {

/// The coarse mesh of the gate: a closed, bumpy ball of 1200 triangles around the origin, within 1.2 of it, seen from
/// outside, with a random shape and random normals (not unit) at its vertices, so that a picture of it differs from
/// pixel to pixel. All numbers are multiples of 2^-12 below 2, so that `subdivided` is exact five times over even in
/// single precision: the finer meshes are the same surface with the same interpolated normals, to the bit.
TriangleMesh growth_mesh(std::uint64_t seed);

/// A ball of the scene of many objects.
struct GrowthBall {
  Point3 center;
  double radius = 0;
};

/// About `count` balls that do not touch, one in each cell of a lattice that fills the cube from -1 to 1; the nearest
/// cube number. Their numbers are multiples of 2^-20.
std::vector<GrowthBall> growth_balls(double count, std::uint64_t seed);

}  // namespace plumb

#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "meshes/triangle_mesh.h"
#include "renderer/math/bounds3.h"
#include "renderer/math/ray.h"

namespace plumb::bench {

/// The same ray as Ray, in the form that a tracer in single precision takes.
struct FloatRay {
  float origin[3], t_min, direction[3], t_max;
};

enum class Question { closest, any };

/// Rays that are asked in this order. Every number is a float (or infinite), so `rays` and `floats` are the same rays.
struct RaySet {
  std::string name;
  Question question = Question::closest;
  std::vector<Ray> rays;
  std::vector<FloatRay> floats;
};

/// What a ray found: the number of the triangle, or kNothing.
struct Found {
  static constexpr std::uint32_t kNothing = 0xffffffffu;
  double t = 0;
  std::uint32_t triangle = kNothing;
  bool hit() const { return triangle != kNothing; }
};

using ClosestHit = std::function<Found(const Ray&)>;

/// primary, incoherent, diffuse, shadow, edge, vertex.
std::vector<std::string_view> ray_set_names();

/// The set of that name: `count` rays at the mesh (`primary`: the largest square number that is not above it). All are
/// drawn from RandomBits with a fixed seed, so the same arguments give the same rays everywhere. d is the length of the
/// box's diagonal.
///
/// - primary: a perspective camera 1.25 d from the box's middle, up and to the side, whose square picture just holds
///   the ball of radius 0.3 d around the middle (most meshes fill most of it); row by row; range [0, infinity).
/// - incoherent: from random points of the sphere of radius d around the box's middle at random points in the box;
///   range [0, infinity).
/// - diffuse: from where the primary rays hit, in their order, equally many from each; directions with a density of the
///   cosine to the triangle's normal on the side that the primary ray saw; unit length; range [2^-12 d, infinity).
///   Where no primary ray hits there are none.
/// - shadow: any-hit; from the same points to a point light beside the camera, 1.5 d from the middle, which is t = 1;
///   range [2^-12, 1].
/// - edge: from the sphere of `incoherent` at a random point of a random edge of a random triangle, rounded to float;
///   range [0, infinity).
/// - vertex: likewise, at a random corner of a random triangle; the directions are rounded, so most rays pass a few
///   units of the last place beside it.
///
/// Directions of the other sets have unit length but for rounding; those of shadow reach the light at t = 1.
/// `closest` is asked for the hits of the primary rays. Requires a mesh whose coordinates are floats, not all at one
/// point. Throws std::invalid_argument for another name.
RaySet make_ray_set(std::string_view name, const TriangleMesh& mesh, std::size_t count, const ClosestHit& closest);

}  // namespace plumb::bench

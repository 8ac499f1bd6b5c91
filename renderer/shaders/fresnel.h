#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "renderer/math/vec3.h"

namespace plumb {

/// Exact: the unpolarised Fresnel equations. Schlick: the approximation that the 2012 course used.
enum class Fresnel { exact, schlick };

/// The names that `--fresnel` takes, in the order of the enumeration.
std::span<const std::string_view> fresnel_names();

/// Light that arrives from a medium of index `from` at one of index `to`; `cosine` in [0,1] is that of the angle
/// between the normal and the direction it came from.
struct Interface {
  double cosine;
  double from;
  double to;
};

/// Snell's law: the cosine on the far side, or nothing under total internal reflection.
std::optional<double> refracted_cosine(const Interface& interface);

/// The share that is reflected, in [0,1]; 1 under total internal reflection. Exact: the mean of both
/// polarisations [Shirley 13.1]. Schlick: R0 + (1 - R0) (1 - c)^5, where c is the cosine on the thinner side
/// [Schlick 1994].
double reflectance(const Interface& interface, Fresnel fresnel);

/// `to_viewer` mirrored about the normal; unit length in, unit length out.
Vec3 reflected(const Vec3& to_viewer, const Normal3& normal);

/// The direction that continues a ray seen along `to_viewer` through the interface; the normal is on the viewer's side.
Vec3 refracted(const Vec3& to_viewer, const Normal3& normal, const Interface& interface, double refracted_cosine);

}  // namespace plumb

#pragma once

#include <random>
#include <string>
#include <vector>

#include "reference/exact_hit.h"

namespace plumb {

/// A shape and a ray in its own frame, made to be hard.
struct SolidCase {
  Shape shape;
  Ray ray;
};

/// Makes one case of a family; all of them draw from the generator given.
struct SolidFamily {
  const char* name;
  SolidCase (*make)(std::mt19937_64&);
};

/// The families of HARD_CASES.md section 2 for one kind.
std::vector<SolidFamily> solid_families(ShapeKind kind);

/// Placements of which each kind must bear every one. On the exact ones (small whole numbers and powers of two) a case
/// of small whole numbers is carried over without rounding, so its ties survive.
struct NamedMatrix {
  const char* name;
  AffineMatrix matrix;
};
std::vector<NamedMatrix> placements();

/// The case in world space, rounded where it must be.
PlacedShape place(const SolidCase& c, const AffineMatrix& matrix);
Ray world_ray(const SolidCase& c, const AffineMatrix& matrix);

/// Empty if the answers agree in every bit of every field, else what differs, in hex floats.
std::string difference(const ExactHit& a, const ExactHit& b);
/// The case as hex floats.
std::string describe(const PlacedShape& placed, const Ray& ray);

}  // namespace plumb

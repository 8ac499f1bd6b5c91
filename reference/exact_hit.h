#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "reference/shape.h"
#include "renderer/math/ray.h"

namespace plumb {

/// What a ray does with a shape, decided exactly.
enum class HitClass {
  miss,
  hit,          ///< the first crossing in the range is a proper one
  boundary,     ///< the first crossing in the range is on an edge or vertex of a triangle, or an edge or rim of a solid
                ///< only touched
  tangent,      ///< the first crossing in the range is a double root
  singular,     ///< the matrix has no inverse: an error is the expected answer
  unsupported,  ///< the shape or the ray (not finite, direction zero, t_min > t_max) is outside of the oracle's domain
};

/// Two doubles with the exact value between them: equal if it is a double, else neighbours. Beyond the largest double
/// the infinity stands, below the smallest denormal zero.
struct Enclosure {
  double below = 0;
  double above = 0;
  bool exact() const { return below == above; }
  friend bool operator==(const Enclosure&, const Enclosure&) = default;
};

/// Where t lies, compared exactly with the ray's range.
enum class RangePlace { within, at_min, at_max };

/// A place where the line of the ray meets the surface, t within the closed range.
struct ExactCrossing {
  Enclosure t;
  /// t rounded to nearest, ties to even.
  double t_double = 0;
  float t_float = 0;
  RangePlace place = RangePlace::within;
  /// A tangent, or the boundary of a triangle, or an edge or rim that the line only touches: a program may report it or
  /// not.
  bool free = false;
  /// What of the shape: the triangle of a mesh; for solids side 0, bottom 1, top 2; for boxes 2 axis + (1 for the upper
  /// face).
  std::uint32_t part = 0;
  /// Triangles: the weights of the second and third vertex, each rounded to nearest.
  double u = 0, v = 0;
  /// In world space: the point, each coordinate correctly rounded for triangles and boxes, else within an ulp of the
  /// largest coordinate; and the outward unit normal (of a triangle: by its winding), each coordinate within 2^-50.
  Point3 position;
  Normal3 normal;
};

/// The certified answer for one ray and one shape.
struct ExactHit {
  HitClass hit_class = HitClass::miss;
  /// The ray's origin lies strictly inside of the solid (false for triangles and meshes).
  bool inside = false;
  /// All crossings in the closed range, by exact t; equal ones by part. A double root stands once.
  std::vector<ExactCrossing> crossings;
};

/// By which way the answer is found. All give the same answer; `filtered` is the fast one, the other two exist so that
/// each can be held against the other: they share neither number type nor formulas.
enum class ExactPath {
  filtered,    ///< doubles with a derived bound, then polynomial
  polynomial,  ///< no division: signs of polynomials in the input (expansions in range, CGAL::Mpzf)
  rational,    ///< the inverse matrix and t as GMP fractions, roots as algebraic numbers
};

/// Intersects one ray (world space) with one placed shape. Never throws for bad numbers: `unsupported`.
ExactHit exact_hit(const PlacedShape& shape, const Ray& ray, ExactPath path = ExactPath::filtered);

/// The nearest surface of several. `winners` are the shapes (and parts) whose proper crossing has the smallest t in the
/// range, ties decided exactly, in the order of the shapes; `free_nearer` are free crossings at or before that t (all
/// of them where nothing is properly hit).
struct ExactClosest {
  struct Entry {
    std::uint32_t shape = 0;
    ExactCrossing crossing;
  };
  std::vector<Entry> winners;
  std::vector<Entry> free_nearer;
};
ExactClosest exact_closest(std::span<const PlacedShape> shapes, const Ray& ray, ExactPath path = ExactPath::filtered);

/// How often each stage decided, summed over the threads' calls since `reset`; for printing the filter's undecided
/// share.
struct ExactStages {
  std::uint64_t filter = 0, expansion = 0, rational = 0;
};
ExactStages exact_stages();
void reset_exact_stages();

}  // namespace plumb

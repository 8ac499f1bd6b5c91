#include <cmath>

#include "conformance/checks/testing/planted_fault.h"
#include "reference/exact_bounds.h"

namespace plumb::planted {
namespace {

template <class Box>
std::function<std::unique_ptr<Subject>()> boxes(Box box) {
  return spoiled([=](Formulas& f) { f.bounds = box; });
}

Bounds3 box_of_the_box(const SubjectSurface& s) { return Transform(s.world_from_object)(exact_bounds({s.shape})); }

/// The scale's row in place of the matrix's.
Bounds3 not_rotated(const SubjectSurface& s) {
  const AffineMatrix& m = s.world_from_object;
  AffineMatrix upright = identity_matrix();
  for (std::size_t i = 0; i < 3; ++i) {
    upright[i][i] = std::sqrt(m[0][i] * m[0][i] + m[1][i] * m[1][i] + m[2][i] * m[2][i]);
    upright[i][3] = m[i][3];
  }
  return Transform(upright)(exact_bounds({s.shape}));
}

Bounds3 of_two_corners(const SubjectSurface& s) {
  const Bounds3 own = exact_bounds({s.shape});
  const Transform world_from_object(s.world_from_object);
  Bounds3 box;
  for (const Point3& corner : {own.min, own.max}) box.extend(world_from_object(corner));
  return box;
}

/// sqrt(sum m^2) r without rounding outwards: half of the faces lie a rounding inside.
Bounds3 rounded_to_nearest(const SubjectSurface& s) {
  if (s.shape.kind != ShapeKind::sphere) return exact_bounds({s.shape, s.world_from_object});
  const Point3 c = Transform(s.world_from_object)(s.shape.center);
  Bounds3 box;
  for (int i = 0; i < 3; ++i) {
    const auto& row = s.world_from_object[static_cast<std::size_t>(i)];
    const double reach = s.shape.radius * std::sqrt(row[0] * row[0] + row[1] * row[1] + row[2] * row[2]);
    box.min[i] = c[i] - reach;
    box.max[i] = c[i] + reach;
  }
  return box;
}

}  // namespace

std::vector<Fault> bounds_faults() {
  return {
      {"A1", "the box of the transformed box", Verdict::quality_warning, "loose", boxes(box_of_the_box)},
      {"A1", "the box is scaled, but not rotated", Verdict::fail, "not_contained", boxes(not_rotated)},
      {"A1", "the right formula, rounded to nearest", Verdict::fail, "not_contained", boxes(rounded_to_nearest)},
      {"bounds", "of the eight corners two are taken", Verdict::fail, "not_contained", boxes(of_two_corners)},
      {"bounds", "the box is not transformed", Verdict::fail, "not_contained",
       boxes([](const SubjectSurface& s) { return exact_bounds({s.shape}); })},
      {"average-position", "the position is not transformed", Verdict::fail, "outside", spoiled([](Formulas& f) {
         f.average_position = [](const SubjectSurface& s) { return exact_bounds({s.shape}).center(); };
       }),
       Right::formulas},
  };
}

}  // namespace plumb::planted

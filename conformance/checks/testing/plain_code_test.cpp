// The other side of every tolerance: code that is right, but as plain as people write it, in doubles and without a
// thought of the last bit, fails no check.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "conformance/checks/check.h"
#include "conformance/checks/testing/formula_subject.h"
#include "conformance/families/placed.h"

namespace plumb::planted {
namespace {

/// By radians, so that the cosine of 90 degrees is 6e-17.
AffineMatrix rotation_about(int axis, double degrees) {
  const double radians = degrees * std::numbers::pi / 180;
  const auto a = static_cast<std::size_t>((axis + 1) % 3), b = static_cast<std::size_t>((axis + 2) % 3);
  AffineMatrix m = identity_matrix();
  m[a][a] = m[b][b] = std::cos(radians);
  m[a][b] = -std::sin(radians);
  m[b][a] = std::sin(radians);
  return m;
}

AffineMatrix matrix_of(const TransformStep& step, bool inverse) {
  const Vec3& v = step.value;
  switch (step.kind) {
    case TransformStep::Kind::translate:
      return translation(inverse ? -v : v);
    case TransformStep::Kind::scale:
      return scaling(inverse ? Vec3{1 / v.x, 1 / v.y, 1 / v.z} : v);
    case TransformStep::Kind::rotate:
      break;
  }
  if (inverse) return rotation_about(0, -v.x) * rotation_about(1, -v.y) * rotation_about(2, -v.z);
  return rotation_about(2, v.z) * rotation_about(1, v.y) * rotation_about(0, v.x);
}

/// The product of the lines, and the product of their inverses the other way round.
SubjectMatrices by_plain_products(const SubjectSurface& surface) {
  SubjectMatrices result{identity_matrix(), identity_matrix(), {}};
  for (const auto& group : surface.groups)
    for (const TransformStep& step : group) {
      result.world_from_object = result.world_from_object * matrix_of(step, false);
      result.inverse = matrix_of(step, true) * result.inverse;
    }
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result.inverse_transpose[i][j] = result.inverse[j][i];
  return result;
}

double by_fresnels_equations(double cosine, double from, double to) {
  const double ratio = from / to;
  const double square = 1 - ratio * ratio * (1 - cosine * cosine);
  if (square < 0) return 1;
  const double far = std::sqrt(square);
  const double parallel = (to * cosine - from * far) / (to * cosine + from * far);
  const double perpendicular = (from * cosine - to * far) / (from * cosine + to * far);
  return (parallel * parallel + perpendicular * perpendicular) / 2;
}

/// By the axis that the direction has least of.
std::array<Vec3, 3> by_cross_products(const Vec3& direction) {
  const Vec3 w = normalized(direction);
  Vec3 other = w;
  other[std::fabs(w.x) < std::fabs(w.y) ? (std::fabs(w.x) < std::fabs(w.z) ? 0 : 2)
                                        : (std::fabs(w.y) < std::fabs(w.z) ? 1 : 2)] = 1;
  const Vec3 u = normalized(cross(other, w));
  return {u, cross(w, u), w};
}

class PlainCode : public ::testing::TestWithParam<const char*> {};

TEST_P(PlainCode, FailsNoCheck) {
  Formulas formulas = right_formulas();
  formulas.matrices = by_plain_products;
  formulas.fresnel = by_fresnels_equations;
  formulas.frame = by_cross_products;
  FormulaSubject subject(std::move(formulas));
  const auto check = std::ranges::find(check_kinds(), GetParam(), &CheckKind::id);
  ASSERT_NE(check, check_kinds().end());
  int asked = 0;
  for (const std::uint64_t seed : {1, 2, 3}) {
    CheckOptions options;
    options.seed = seed;
    options.intensity = 0.02;
    const CheckResult result = run_check(**check, subject, options);
    EXPECT_EQ(to_string(result.verdict), "pass") << result.cause << ": " << result.summary << "\n" << result.advice;
    ++asked;
  }
  EXPECT_EQ(asked, 3);
}

INSTANTIATE_TEST_SUITE_P(All, PlainCode, ::testing::Values("matrices", "M4", "F1", "N1"));

}  // namespace
}  // namespace plumb::planted

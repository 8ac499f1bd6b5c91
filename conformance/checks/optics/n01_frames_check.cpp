#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "conformance/checks/check.h"
#include "conformance/checks/describe.h"
#include "conformance/checks/hit_judge.h"
#include "conformance/families/random.h"
#include "conformance/families/rounding.h"

namespace plumb {
namespace {

constexpr double kDirections = 5'000;
/// A dot product of two unit vectors is off by 2 u of rounding, and each vector by as much; likewise the lengths.
constexpr double kUnits = 4;
constexpr double kLengthUnits = 8;

/// The poles where usual constructions divide by zero, with zeros of both signs; then directions close to them, and
/// random ones.
std::vector<Vec3> directions(std::uint64_t seed, std::int64_t count, bool as_float) {
  std::vector<Vec3> all;
  for (const double z : {0.0, -0.0})
    for (const double one : {1.0, -1.0})
      for (const Vec3& v :
           {Vec3{one, z, z}, Vec3{z, one, z}, Vec3{z, z, one}, Vec3{one, z, -z}, Vec3{z, one, -z}, Vec3{z, -z, one}})
        all.push_back(v);
  Random random(seed, "N1", 0);
  while (static_cast<std::int64_t>(all.size()) < count) {
    Vec3 v{2 * random.unit() - 1, 2 * random.unit() - 1, 2 * random.unit() - 1};
    if (random.below(2)) {
      const int axis = static_cast<int>(random.below(3));
      const double tiny = std::ldexp(1.0, -static_cast<int>(random.below(as_float ? 24 : 53)));
      for (int other = 0; other < 3; ++other)
        if (other != axis) v[other] *= tiny;
    }
    if (length(v) < 0x1p-60) continue;
    all.push_back(Rounding(as_float ? PLUMB_FLOAT : PLUMB_DOUBLE)(normalized(v)));
  }
  return all;
}

/// The largest fault of a frame in units of its tolerance.
double fault(const Vec3& direction, const std::array<Vec3, 3>& frame, double u) {
  for (const Vec3& v : frame)
    if (!is_finite(v)) return Bounds3::kInfinity;
  const auto& [a, b, c] = frame;
  const auto product = [](const Vec3& p, const Vec3& q) {
    return static_cast<double>(static_cast<long double>(p.x) * q.x + static_cast<long double>(p.y) * q.y +
                               static_cast<long double>(p.z) * q.z);
  };
  double largest =
      std::max({std::fabs(product(a, b)), std::fabs(product(b, c)), std::fabs(product(c, a))}) / (kUnits * u);
  for (const Vec3& v : frame) largest = std::max(largest, std::fabs(product(v, v) - 1) / (kLengthUnits * u));
  const Vec3 across = cross(c, direction);
  return std::max(largest,
                  dot(c, direction) > 0 ? length(across) / (kLengthUnits * u * length(direction)) : Bounds3::kInfinity);
}

CheckResult run(Subject& subject, const CheckOptions& options) {
  if (!subject.contract().frame) throw UnsupportedBySubject(subject.name() + " does not answer frames");
  const bool as_float = subject.contract().precision == PLUMB_FLOAT;
  const double u = unit_roundoff(subject.contract().precision);
  const auto count = static_cast<std::int64_t>(std::ceil(kDirections * options.intensity));
  std::int64_t wrong = 0, asked = 0;
  double largest = 0;
  std::string worst;
  for (const Vec3& direction : directions(options.seed, count, as_float)) {
    const double found = fault(direction, subject.frame(direction), u);
    ++asked;
    wrong += found > 1;
    if (found > largest || worst.empty()) {
      largest = found;
      worst = fmt::format("({}, {}, {})", hex(direction.x), hex(direction.y), hex(direction.z));
    }
  }
  CheckResult result;
  result.verdict = wrong == 0 ? Verdict::pass : Verdict::fail;
  result.cause = wrong == 0 ? "" : "frame";
  result.margin = 1 - largest;
  result.evidence = {
      {"directions", asked}, {"wrong", wrong}, {"largest_error_over_allowed", largest}, {"worst", worst}};
  result.summary =
      fmt::format("{} frames, {} wrong; the worst error is {:.2g} of what is allowed", asked, wrong, largest);
  if (wrong > 0) result.advice = "the axes are not orthonormal, or the third is not along the direction, for " + worst;
  return result;
}

}  // namespace

extern const CheckKind n01_frames_check_kind{
    .id = "N1",
    .title = "Orthonormal frames about a direction",
    .asks = "Three axes, the third along the direction, also where the direction is an axis with zeros of either sign.",
    .matters =
        "A NaN basis blackens what faces straight up or down: glossy floors, the view along an axis, area lights.",
    .tolerance =
        "Dot products within 4 u and squared lengths within 8 u of exact: two roundings a product, and as many in each "
        "vector.",
    .run = run,
};

}  // namespace plumb

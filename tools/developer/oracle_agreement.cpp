#include "tools/developer/oracle_agreement.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "conformance/checks/describe.h"
#include "conformance/families/random.h"
#include "reference/exact_bounds.h"
#include "reference/exact_hit.h"
#include "reference/exact_optics.h"
#include "reference/exact_transform.h"
#include "reference/exact_transform_cross_check.h"

namespace plumb {
namespace {

/// For what is compared with the certified way, whose own precision begins at 256.
constexpr int kOtherBits = 1408;

bool same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

template <class Triple>
bool same_triple(const Triple& a, const Triple& b) {
  return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

bool same(const ExactCrossing& a, const ExactCrossing& b) {
  return a.t == b.t && same(a.t_double, b.t_double) && a.t_float == b.t_float && a.place == b.place &&
         a.free == b.free && a.part == b.part && same(a.u, b.u) && same(a.v, b.v) &&
         same_triple(a.position, b.position) && same_triple(a.normal, b.normal);
}

bool same(const ExactHit& a, const ExactHit& b) {
  return a.hit_class == b.hit_class && a.inside == b.inside &&
         std::ranges::equal(a.crossings, b.crossings, [](const auto& x, const auto& y) { return same(x, y); });
}

bool same(const BoundsVerdict& a, const BoundsVerdict& b) {
  return a.contains == b.contains && a.ulps_loose == b.ulps_loose;
}

/// Two enclosures of one number cannot be disjoint.
bool meet(const Enclosure& a, const Enclosure& b) { return a.below <= b.above && b.below <= a.above; }

void note(OracleAgreement& agreement, bool agree, const std::string& what) {
  ++agreement.cases;
  if (agree) return;
  if (agreement.disagreements++ == 0) agreement.first = what;
}

void compare_ray(const PlacedShape& shape, const Ray& ray, OracleAgreement& agreement) {
  const ExactHit polynomial = exact_hit(shape, ray, ExactPath::polynomial);
  const ExactHit rational = exact_hit(shape, ray, ExactPath::rational);
  const ExactStages before = exact_stages();
  const ExactHit filtered = exact_hit(shape, ray, ExactPath::filtered);
  const ExactStages after = exact_stages();
  agreement.undecided += after.expansion + after.rational > before.expansion + before.rational;
  note(agreement, same(polynomial, rational) && same(filtered, rational), oracle_command(shape, ray));
}

double moved(double face, Random& random) {
  const std::uint32_t way = random.below(3);
  return way == 0 ? face : std::nextafter(face, way == 1 ? -Bounds3::kInfinity : Bounds3::kInfinity);
}

void compare_box(const PlacedShape& shape, Random& random, OracleAgreement& agreement) {
  Bounds3 claimed = exact_bounds(shape);
  for (int axis = 0; axis < 3; ++axis) {
    claimed.min[axis] = moved(claimed.min[axis], random);
    claimed.max[axis] = moved(claimed.max[axis], random);
  }
  note(agreement, same(judge_bounds(shape, claimed), judge_bounds_rational(shape, claimed)),
       "the box of " + oracle_command(shape, Ray{}));
}

std::vector<TransformStep> all_steps(const SubjectSurface& surface) {
  std::vector<TransformStep> steps;
  for (const auto& group : surface.groups) steps.insert(steps.end(), group.begin(), group.end());
  return steps;
}

bool meet(const EnclosedMatrix& a, const EnclosedMatrix& b) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      if (!meet(a[i][j], b[i][j])) return false;
  return true;
}

void compare_rotation(const SubjectSurface& surface, OracleAgreement& agreement) {
  const std::vector<TransformStep> steps = all_steps(surface);
  bool agree = meet(certified_product(steps), certified_product_by_quaternions(steps, kOtherBits));
  EnclosedMatrix inverse, other;
  const bool invertible = certified_inverse(steps, inverse);
  agree = agree && invertible == certified_inverse_by_quaternions(steps, kOtherBits, other);
  if (agree && invertible) agree = meet(inverse, other);
  for (const TransformStep& step : steps) {
    if (step.kind != TransformStep::Kind::rotate) continue;
    for (int axis = 0; axis < 3; ++axis) {
      const EnclosedCosSin a = certified_cos_sin(step.value[axis]);
      const EnclosedCosSin b = certified_cos_sin_by_radians(step.value[axis], kOtherBits);
      agree = agree && meet(a.cos, b.cos) && meet(a.sin, b.sin);
    }
  }
  note(agreement, agree, "the product of " + std::to_string(steps.size()) + " transforms");
}

}  // namespace

OracleAgreement agree_on_rays(const FamilyKind& family, std::int64_t count) {
  OracleAgreement agreement{.family = std::string(family.id)};
  for (const plumb_precision precision : {PLUMB_FLOAT, PLUMB_DOUBLE}) {
    const auto source = family.make(1, precision);
    const std::int64_t until = precision == PLUMB_FLOAT ? (count + 1) / 2 : count;
    while (agreement.cases < until) {
      const FamilyCase one = source->next();
      for (const Ray& ray : one.rays) compare_ray({one.surface.shape, one.surface.world_from_object}, ray, agreement);
    }
  }
  return agreement;
}

OracleAgreement agree_on_boxes(const FamilyKind& family, std::int64_t count) {
  OracleAgreement agreement{.family = std::string(family.id) + " boxes"};
  const auto source = family.make(1, PLUMB_DOUBLE);
  const ExactStages before = exact_stages();
  for (std::int64_t i = 0; i < count; ++i) {
    Random random(1, family.id, static_cast<std::uint64_t>(i));
    const FamilyCase one = source->next();
    compare_box({one.surface.shape, one.surface.world_from_object}, random, agreement);
  }
  const ExactStages after = exact_stages();
  // Each case asks for the box, and judges one.
  agreement.undecided = static_cast<std::int64_t>(after.expansion - before.expansion) / 2;
  return agreement;
}

OracleAgreement agree_on_rotations(std::int64_t count) {
  OracleAgreement agreement{.family = "M4 matrices"};
  const auto right_angles = family_kind("M4").make(1, PLUMB_DOUBLE);
  const auto nested = family_kind("M1").make(1, PLUMB_DOUBLE);
  while (agreement.cases < count) {
    compare_rotation(right_angles->next().surface, agreement);
    compare_rotation(nested->next().surface, agreement);
  }
  return agreement;
}

OracleAgreement agree_on_fresnel(std::int64_t count) {
  OracleAgreement agreement{.family = "F1"};
  for (std::int64_t i = 0; i < count; ++i) {
    Random random(1, "F1", static_cast<std::uint64_t>(i));
    const double from = 1 + random.unit(), ratio = random.coin() ? 1 + random.magnitude(1e-12, 1) : 1 + random.unit();
    const double to = random.coin() ? from * ratio : from / ratio;
    double cosine = random.unit();
    if (random.coin() && to < from) {  // about the critical angle
      const double critical = std::sqrt(std::max(0.0, (1 - to / from) * (1 + to / from)));
      cosine = std::clamp(critical + random.sign() * random.magnitude(1e-17, 1e-4), 0.0, 1.0);
    }
    const ExactFresnel a = exact_fresnel(cosine, from, to);
    const ExactFresnel b = exact_fresnel_by_angles(cosine, from, to, 384);
    note(agreement,
         a.total_internal_reflection == b.total_internal_reflection && a.critical == b.critical &&
             meet(a.reflectance, b.reflectance) && meet(a.refracted_cosine, b.refracted_cosine),
         "cosine " + hex(cosine) + " from " + hex(from) + " to " + hex(to));
  }
  return agreement;
}

}  // namespace plumb

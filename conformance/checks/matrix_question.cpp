#include "conformance/checks/matrix_question.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "conformance/checks/bounds_question.h"
#include "conformance/checks/describe.h"
#include "conformance/checks/hit_judge.h"
#include "reference/exact_transform.h"

namespace plumb {
namespace {

constexpr double kPassUnits = 32;
constexpr double kWarnUnits = 0x1p20;

AffineMatrix absolute(AffineMatrix m) {
  for (auto& row : m)
    for (double& entry : row) entry = std::fabs(entry);
  return m;
}

/// Errors of one kind of matrix over all surfaces.
struct Errors {
  explicit Errors(std::string_view of) : name(of) {}

  std::string_view name;
  std::vector<double> units, ulps;
  double worst = 0;
  std::string worst_entry;

  void add(double claimed, const Enclosure& exact, double bound, double u, const std::string& where) {
    const double off = std::isnan(claimed)     ? std::numeric_limits<double>::infinity()
                       : claimed < exact.below ? exact.below - claimed
                       : claimed > exact.above ? claimed - exact.above
                                               : 0;
    const double nearest = claimed < exact.below ? exact.below : exact.above;
    const double ulp = std::max(std::fabs(nearest) * 2 * u, std::numeric_limits<double>::denorm_min());
    const double unit = off == 0 ? 0 : off / std::max(bound * u, std::numeric_limits<double>::denorm_min());
    units.push_back(unit);
    ulps.push_back(off / ulp);
    if (unit > worst || worst_entry.empty()) {
      worst = unit;
      worst_entry = fmt::format("{} is {} ({:.17g}), exactly between {} and {}", where, hex(claimed), claimed,
                                hex(exact.below), hex(exact.above));
    }
  }

  static double high(std::vector<double>& values) {
    if (values.empty()) return 0;
    const auto place = static_cast<std::ptrdiff_t>(std::ceil(0.99 * static_cast<double>(values.size() - 1)));
    std::ranges::nth_element(values, values.begin() + place);
    return values[static_cast<std::size_t>(place)];
  }
};

std::vector<TransformStep> flattened(const SubjectSurface& surface) {
  std::vector<TransformStep> steps;
  for (const auto& group : surface.groups) steps.insert(steps.end(), group.begin(), group.end());
  return steps;
}

/// The groups multiplied as they should be, but each group's own lines in the reverse order.
std::vector<TransformStep> lines_reversed(const SubjectSurface& surface) {
  std::vector<TransformStep> steps;
  for (const auto& group : surface.groups) steps.insert(steps.end(), group.rbegin(), group.rend());
  return steps;
}

std::vector<TransformStep> all_reversed(const SubjectSurface& surface) {
  std::vector<TransformStep> steps = flattened(surface);
  std::ranges::reverse(steps);
  return steps;
}

std::vector<TransformStep> groups_reversed(const SubjectSurface& surface) {
  std::vector<TransformStep> steps;
  for (auto group = surface.groups.rbegin(); group != surface.groups.rend(); ++group)
    steps.insert(steps.end(), group->begin(), group->end());
  return steps;
}

/// Rx Ry Rz in place of Rz Ry Rx.
std::vector<TransformStep> rotations_reversed(const SubjectSurface& surface) {
  std::vector<TransformStep> steps;
  for (const TransformStep& step : flattened(surface)) {
    if (step.kind != TransformStep::Kind::rotate) {
      steps.push_back(step);
      continue;
    }
    for (const Vec3& one : {Vec3{step.value.x, 0, 0}, Vec3{0, step.value.y, 0}, Vec3{0, 0, step.value.z}})
      steps.push_back({TransformStep::Kind::rotate, one});
  }
  return steps;
}

/// A usual mistake: named where the product that it makes fits every surface.
struct Mistake {
  std::string_view cause, sentence;
  std::vector<TransformStep> (*steps)(const SubjectSurface&);
};
constexpr std::array<Mistake, 4> kMistakes{{
    {"rotation_order", "rotations are applied about z first; they are about x, then y, then z: Rz Ry Rx",
     rotations_reversed},
    {"order", "the lines of a group are multiplied in the reverse order; the first is the outermost", lines_reversed},
    {"order", "all transforms are multiplied in the reverse order; the first line of the outer group is the outermost",
     all_reversed},
    {"group_order", "nested groups are multiplied from the inside; the outer group is the outermost", groups_reversed},
}};

AffineMatrix step_matrix(const TransformStep& step) {
  switch (step.kind) {
    case TransformStep::Kind::translate:
      return translation(step.value);
    case TransformStep::Kind::rotate:
      return rotation_degrees(step.value);
    case TransformStep::Kind::scale:
      return scaling(step.value);
  }
  return identity_matrix();
}

/// What the roundings of a product scale with, in u: |A1||A2|...|An| for those of the product itself, and for each
/// rotation Ri the sum |A1|...|Ei|...|An| for those of its entries, which are absolute: the cosine of a right angle in
/// radians is not 0 but 0.6 u. Ei is 1 where cosines and sines stand. Two such errors may meet where all of that is 0,
/// so they are multiplied out: |Ai| + u Ei for each |Ai|.
class ProductBound {
 public:
  explicit ProductBound(double u) : u_(u) {}

  void multiply(const AffineMatrix& factor) {
    product_ = product_ * absolute(factor);
    of_rotations_ = of_rotations_ * absolute(factor);
  }

  void rotate(int axis, double degrees) {
    Vec3 angles;
    angles[axis] = degrees;
    AffineMatrix off{};
    for (const int row : {(axis + 1) % 3, (axis + 2) % 3})
      for (const int column : {(axis + 1) % 3, (axis + 2) % 3})
        off[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = 1;
    AffineMatrix own = sum(product_, of_rotations_, u_) * off;
    for (auto& row : own) row[3] = 0;
    multiply(rotation_degrees(angles));
    of_rotations_ = sum(of_rotations_, own, 1);
  }

  AffineMatrix total() const { return sum(product_, of_rotations_, 1); }

 private:
  /// a + times b.
  static AffineMatrix sum(AffineMatrix a, const AffineMatrix& b, double times) {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 4; ++j) a[i][j] += times * b[i][j];
    return a;
  }

  double u_;
  AffineMatrix product_ = identity_matrix(), of_rotations_{};
};

AffineMatrix product_bound(std::span<const TransformStep> steps, double u) {
  ProductBound bound(u);
  for (const TransformStep& step : steps) {
    if (step.kind != TransformStep::Kind::rotate) {
      bound.multiply(step_matrix(step));
      continue;
    }
    // A rotation is itself a product of three.
    for (const int axis : {2, 1, 0}) bound.rotate(axis, step.value[axis]);
  }
  return bound.total();
}

std::string steps_text(std::span<const TransformStep> steps) {
  std::string text;
  for (const TransformStep& step : steps) {
    const char* name = step.kind == TransformStep::Kind::translate ? "translate"
                       : step.kind == TransformStep::Kind::rotate  ? "rotate"
                                                                   : "scale";
    text += fmt::format(" --{} {:.17g},{:.17g},{:.17g}", name, step.value.x, step.value.y, step.value.z);
  }
  return text;
}

AffineMatrix rounded(const EnclosedMatrix& m) {
  AffineMatrix result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j) result[i][j] = m[i][j].below;
  return result;
}

class MatrixJudge {
 public:
  explicit MatrixJudge(const Contract& contract) : u_(unit_roundoff(contract.precision)) {}

  void judge(const SubjectSurface& surface, const SubjectMatrices& claimed) {
    ++surfaces_;
    const std::vector<TransformStep> steps = flattened(surface);
    const std::string command = "plumb oracle matrix" + steps_text(steps);
    judge_world(surface, steps, claimed.world_from_object, command);
    EnclosedMatrix inverse;
    EnclosedMatrix3 transpose;
    if (!certified_inverse(claimed.world_from_object, inverse) ||
        !certified_inverse_transpose(claimed.world_from_object, transpose))
      return;
    const AffineMatrix exact = absolute(rounded(inverse));
    const AffineMatrix bound = exact * product_bound(steps, u_) * exact;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 4; ++j)
        inverse_.add(claimed.inverse[i][j], inverse[i][j], bound[i][j], u_,
                     fmt::format("entry {},{} of the inverse for {}", i, j, command));
      for (std::size_t j = 0; j < 3; ++j)
        transpose_.add(claimed.inverse_transpose[i][j], transpose[i][j], bound[j][i], u_,
                       fmt::format("entry {},{} of the inverse transpose for {}", i, j, command));
    }
  }

  CheckResult verdict() {
    CheckResult result;
    result.verdict = Verdict::pass;
    result.evidence.emplace_back("surfaces", surfaces_);
    double largest_ulps = 0;
    double margin = kPassUnits;
    for (Errors* errors : {&world_, &inverse_, &transpose_}) {
      const double units = Errors::high(errors->units);
      const double ulps = Errors::high(errors->ulps);
      largest_ulps = std::max(largest_ulps, ulps);
      margin = std::min(margin, kPassUnits - units);
      const std::string name(errors->name);
      result.evidence.emplace_back(name + "_units_p99", units);
      result.evidence.emplace_back(name + "_units_largest", errors->worst);
      result.evidence.emplace_back(name + "_ulps_p99", ulps);
      result.evidence.emplace_back(name + "_worst", errors->worst_entry);
      result.summary +=
          fmt::format("{}{} off by {:.2g} units at 99 %", result.summary.empty() ? "" : ", ", name, units);
      if (errors->worst > kWarnUnits && result.verdict != Verdict::fail) {
        result.verdict = Verdict::fail;
        result.cause = name;
        result.advice = errors->worst_entry;
        for (std::size_t k = 0; errors == &world_ && k < kMistakes.size(); ++k) {
          if (fits_[k] < surfaces_) continue;
          result.cause = kMistakes[k].cause;
          result.advice = std::string(kMistakes[k].sentence) + ": " + errors->worst_entry;
          break;
        }
      } else if (units > kPassUnits && result.verdict == Verdict::pass) {
        result.verdict = Verdict::quality_warning;
        result.cause = "inexact_" + name;
        result.advice = errors->worst_entry;
      }
    }
    result.margin = margin;
    result.evidence.emplace_back("gold", std::string(largest_ulps <= kPassUnits ? "yes" : "no"));
    return result;
  }

 private:
  void judge_world(const SubjectSurface& surface, const std::vector<TransformStep>& steps, const AffineMatrix& claimed,
                   const std::string& command) {
    const EnclosedMatrix exact = certified_product(steps);
    const AffineMatrix bound = product_bound(steps, u_);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 4; ++j)
        world_.add(claimed[i][j], exact[i][j], bound[i][j], u_, fmt::format("entry {},{} for {}", i, j, command));
    for (std::size_t k = 0; k < kMistakes.size(); ++k) fits_[k] += fits(kMistakes[k].steps(surface), claimed);
  }

  bool fits(const std::vector<TransformStep>& steps, const AffineMatrix& claimed) const {
    const AffineMatrix product = rounded(certified_product(steps));
    const AffineMatrix bound = product_bound(steps, u_);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 4; ++j)
        if (!(std::fabs(claimed[i][j] - product[i][j]) <= kWarnUnits * u_ * bound[i][j])) return false;
    return true;
  }

  double u_;
  std::int64_t surfaces_ = 0;
  std::array<std::int64_t, kMistakes.size()> fits_{};
  Errors world_{"world"}, inverse_{"inverse"}, transpose_{"inverse_transpose"};
};

}  // namespace

CheckResult check_matrices(std::span<const std::string_view> families, Subject& subject, const CheckOptions& options) {
  if (!subject.contract().matrices) throw UnsupportedBySubject(subject.name() + " does not report matrices");
  const std::vector<SubjectScene> scenes = bounds_scenes(families, subject, options);
  MatrixJudge judge(subject.contract());
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    subject.load(scenes[i]);
    const std::vector<SubjectMatrices> claimed = subject.matrices();
    for (std::size_t k = 0; k < scenes[i].size(); ++k) judge.judge(scenes[i][k], claimed[k]);
    options.progress(static_cast<double>(i + 1) / static_cast<double>(scenes.size()));
  }
  return judge.verdict();
}

}  // namespace plumb

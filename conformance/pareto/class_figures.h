#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "conformance/families/family.h"
#include "conformance/families/rounding.h"
#include "conformance/pareto/contender.h"
#include "conformance/results/pareto_results.h"
#include "reference/exact_hit.h"

namespace plumb {

/// A family, or a part of one: a row of the tables.
struct ClassQuestion {
  std::string_view family;  ///< its id: `T8`
  std::string_view name;    ///< `huge`
  bool (*includes)(const FamilyCase& one, const Rounding& rounded);
};

/// The rows of single triangles: control, edge, vertex, grazing, needle, far, huge, small.
std::span<const ClassQuestion> triangle_questions();
/// The rows of spheres: S0 to S5, and M1 where the matrix is ill-conditioned (from 1e6 on; float inputs: from 1e2).
std::span<const ClassQuestion> sphere_questions();

/// The exact answers to a case, taken once for all kernels that are asked.
class CaseTruth {
 public:
  explicit CaseTruth(const FamilyCase& one);
  const ExactHit& hit(std::size_t ray) const { return hits_[ray]; }
  const PlacedShape& shape() const { return shape_; }
  /// edge_margin of a ray at a triangle in units of a precision; 0 for other shapes.
  double margin(std::size_t ray, plumb_precision precision);

 private:
  PlacedShape shape_;
  std::vector<Ray> rays_;
  std::vector<ExactHit> hits_;
  /// In units of 2^-24; negative where it was not asked for yet.
  std::vector<double> margins_;
};

/// Counts the answers of one kernel, by the rules of judge_answer.
class ClassTally {
 public:
  ClassTally(const ClassQuestion& question, const Contract& contract);
  /// One answer a ray of the case.
  void judge(const FamilyCase& one, CaseTruth& truth, std::span<const SubjectHit> answers);
  void leave_out(const FamilyCase& one) { figure_.left_out += static_cast<std::int64_t>(one.rays.size()); }
  ClassFigure figure() &&;

 private:
  const Contract& contract_;
  ClassFigure figure_;
  std::vector<double> t_ulps_;
};

/// Asks each contender (of one precision of inputs) the same rays of a question, `count` or up to a case's more. One
/// figure a contender, without rays where it failed.
std::vector<ClassFigure> class_figures(std::span<Contender* const> contenders, const ClassQuestion& question,
                                       std::uint64_t seed, std::int64_t count,
                                       const std::function<void(double)>& progress);

}  // namespace plumb

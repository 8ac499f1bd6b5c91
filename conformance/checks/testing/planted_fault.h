#pragma once

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "conformance/checks/testing/formula_subject.h"

namespace plumb::planted {

/// Who passes the check on which the planted mistake fails: the tracer's kernel, or right_formulas() where the check
/// asks what no kernel is asked.
enum class Right { tracer, formulas };

/// A subject with one mistake as people make it, and what the check that is there to find it says.
struct Fault {
  std::string_view check;
  std::string_view mistake;
  Verdict verdict = Verdict::fail;
  std::string_view cause;
  std::function<std::unique_ptr<Subject>()> wrong;
  Right right = Right::tracer;
  /// Of both runs.
  double intensity = 0.01;
};

std::vector<Fault> triangle_faults();
std::vector<Fault> box_faults();
std::vector<Fault> round_solid_faults();
std::vector<Fault> transform_faults();
std::vector<Fault> bounds_faults();
std::vector<Fault> search_faults();
std::vector<Fault> optics_faults();

/// right_formulas() with this done to them.
std::function<std::unique_ptr<Subject>()> spoiled(std::function<void(Formulas&)> spoil);

/// Formulas that tell nothing but hits, as a kernel does: no matrices, no normals.
std::function<std::unique_ptr<Subject>()> kernel_with(
    std::function<std::vector<LocalHit>(const Shape&, const Ray&)> hits);

}  // namespace plumb::planted

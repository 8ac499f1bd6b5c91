#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/subject/subject.h"
#include "conformance/verdict.h"

namespace plumb {

/// How much is asked, and from where the random numbers start.
struct CheckOptions {
  /// Multiplies the counts of every check; 1 takes a few seconds a check on a fast kernel.
  double intensity = 1;
  std::uint64_t seed = 1;
  /// Told the share that is done.
  std::function<void(double)> progress = [](double) {};
};

/// One thing that is asked of a subject. Each is one file in `conformance/checks/AREA/`, with one constant NAME_check.
struct CheckKind {
  std::string_view id;         ///< `T1`, `leak-mesh`, `bounds`
  std::string_view title;      ///< `Rays at the edges of a triangle`
  std::string_view asks;       ///< what is asked, a sentence or two
  std::string_view matters;    ///< what of a picture goes wrong where it fails
  std::string_view tolerance;  ///< the derivation of its threshold
  /// Asks and judges. Evidence: counts, rates, the worst case as hex floats. Throws UnsupportedBySubject and
  /// SubjectFailure, which run_check turns into verdicts.
  CheckResult (*run)(Subject& subject, const CheckOptions& options);
  /// A subject that is both a kernel and a probe is asked as a probe: only that one knows groups and normals.
  bool probe_first = false;
};

/// All, by file.
std::span<const CheckKind* const> check_kinds();
/// All, in the catalogue's order: triangles, boxes, spheres, cylinders and cones, transforms, ellipsoids, optics,
/// frames, by number; then those with a word for an id.
std::vector<const CheckKind*> checks_in_order();

/// Runs one check: exceptions of the subject become verdicts; anything else is internal_error.
CheckResult run_check(const CheckKind& check, Subject& subject, const CheckOptions& options);

}  // namespace plumb

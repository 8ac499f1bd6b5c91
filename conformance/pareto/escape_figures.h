#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "conformance/families/closed_meshes.h"
#include "conformance/pareto/contender.h"
#include "conformance/pareto/mesh_aim.h"
#include "conformance/results/pareto_results.h"

namespace plumb {

/// Counts the escapes of one kernel: rays from inside of closed meshes that hit nothing.
class EscapeTally {
 public:
  EscapeTally(MeshAim aim, plumb_precision precision);
  /// One answer a ray.
  void judge(const ClosedSurface& closed, std::span<const Ray> rays, std::span<const SubjectHit> answers);
  EscapeFigure figure() &&;

 private:
  plumb_precision precision_;
  EscapeFigure figure_;
  std::int64_t worst_ = 0;
  std::vector<double> margins_;
};

/// Shoots `count` rays, evenly over the meshes (rounded up), with each contender (of one precision of inputs). One
/// figure a contender, without rays where it failed.
std::vector<EscapeFigure> escape_figures(std::span<Contender* const> contenders, std::span<const ClosedSurface> meshes,
                                         MeshAim aim, std::uint64_t seed, std::int64_t count,
                                         const std::function<void(double)>& progress);

}  // namespace plumb

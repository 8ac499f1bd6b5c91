#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "conformance/pareto/contender.h"
#include "conformance/pareto/mesh_aim.h"
#include "conformance/results/pareto_results.h"
#include "reference/exact_hit.h"

namespace plumb {

/// A mesh whose nearest triangle is asked for.
struct ClosestScene {
  std::string name;
  SubjectSurface surface;
};

/// `sphere`: an icosphere of 320 triangles. `cube`: 768, those of a face in one plane. `shells`: two icospheres of 320,
/// the outer one larger by 2^-20: its triangles lie some units of the last place of a float before the others.
std::vector<ClosestScene> closest_scenes(plumb_precision precision);

/// What is wrong with a reported triangle.
enum class ClosestFault {
  none,
  missed,  ///< a triangle is properly hit, and none was reported
  beside,  ///< a triangle was reported that the ray does not meet
  behind,  ///< a triangle was reported that the ray meets, but behind the first that is properly hit
};

/// Right is a triangle whose t is exactly the smallest of those properly hit, one that is met on its boundary not
/// behind it, and, where none is properly hit, none.
ClosestFault closest_fault(const ExactClosest& truth, const TriangleMesh& mesh, const Ray& ray,
                           const SubjectHit& answer);

/// Counts the answers of one kernel about one mesh.
class ClosestTally {
 public:
  ClosestTally(const ClosestScene& scene, MeshAim aim, const Contract& contract);
  void judge(const Ray& ray, const ExactClosest& truth, const SubjectHit& answer);
  ClosestFigure figure() && { return std::move(figure_); }

 private:
  const TriangleMesh& mesh_;
  const Contract& contract_;
  ClosestFigure figure_;
};

/// Shoots `count` rays from outside of the mesh with each contender (of one precision of inputs). One figure a
/// contender, without rays where it failed.
std::vector<ClosestFigure> closest_figures(std::span<Contender* const> contenders, const ClosestScene& scene,
                                           MeshAim aim, std::uint64_t seed, std::int64_t count,
                                           const std::function<void(double)>& progress);

}  // namespace plumb

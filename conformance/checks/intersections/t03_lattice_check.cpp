#include <algorithm>

#include "conformance/checks/class_check.h"
#include "conformance/checks/leak_question.h"

namespace plumb {
namespace {

/// Of the rays that the check of all closed meshes shoots.
constexpr double kShare = 0.1;

/// Those of whole numbers, of whose rays every second meets vertices and edges exactly.
std::vector<ClosedSurface> lattice_meshes(plumb_precision precision) {
  std::vector<ClosedSurface> list = closed_meshes(precision);
  std::erase_if(list, [](const ClosedSurface& closed) { return !closed.name.starts_with("cube"); });
  return list;
}

CheckResult run(Subject& subject, const CheckOptions& options) {
  CheckResult result = check_family("T3", subject, options);
  const Contract& contract = subject.contract();
  if (!is_right(result.verdict) || contract.edge_rule == PLUMB_EDGE_NONE) return result;
  CheckOptions fewer = options;
  fewer.intensity *= kShare;
  const CheckResult leaks = check_leaks(lattice_meshes(family_precision(contract, ShapeKind::mesh)), subject, fewer);
  for (const auto& [name, value] : leaks.evidence)
    if (name != "contract") result.evidence.emplace_back("mesh_" + name, value);
  result.summary += "; " + leaks.summary;
  if (is_right(leaks.verdict)) return result;
  result.verdict = leaks.verdict;
  result.cause = leaks.cause;
  result.margin = leaks.margin;
  result.advice = leaks.advice;
  return result;
}

}  // namespace

extern const CheckKind t03_lattice_check_kind{
    .id = "T3",
    .title = "Rays exactly through edges and vertices",
    .asks =
        "Triangles with whole-number vertices, hit exactly on an edge or a vertex; and closed cubes of such triangles, "
        "from inside.",
    .matters = "Axis-aligned models seen along the axes lose lines of pixels.",
    .tolerance =
        "As for the other families of single surfaces, where a hit exactly on the boundary is free. Of a cube's "
        "triangles one must be hit: no escape, unless the contract promises nothing of edges.",
    .run = run,
};

}  // namespace plumb

#include "meshes/validation/mesh_report.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumb {
namespace {

/// How a fault is told. `one` and `many` follow the count.
struct Wording {
  std::string_view id, one, many, examples;
  const MeshFault* (*fault)(const MeshReport&);
};

template <MeshFault MeshReport::*field>
const MeshFault* get(const MeshReport& report) {
  return &(report.*field);
}
const MeshFault* get_self_intersections(const MeshReport& report) {
  return report.self_intersections ? &*report.self_intersections : nullptr;
}

constexpr Wording kWordings[] = {
    {"boundary_edges", "edge has a triangle on one side only: the surface has a hole or a rim",
     "edges have a triangle on one side only: the surface has holes or a rim", "triangles",
     get<&MeshReport::boundary_edges>},
    {"edges_of_many", "edge is shared by three or more triangles", "edges are shared by three or more triangles",
     "triangles", get<&MeshReport::edges_of_many>},
    {"misoriented_edges", "edge joins two triangles of which one is wound the other way round",
     "edges join two triangles of which one is wound the other way round", "triangles",
     get<&MeshReport::misoriented_edges>},
    {"vertices_of_many_fans", "vertex joins parts of the surface that share no edge there (a bow tie)",
     "vertices join parts of the surface that share no edge there (bow ties)", "vertices",
     get<&MeshReport::vertices_of_many_fans>},
    {"repeated_corners", "triangle names the same vertex twice", "triangles name the same vertex twice", "triangles",
     get<&MeshReport::repeated_corners>},
    {"zero_area", "triangle has no area: its corners lie on a line",
     "triangles have no area: their corners lie on a line", "triangles", get<&MeshReport::zero_area>},
    {"duplicate_triangles", "triangle repeats the corners of an earlier one",
     "triangles repeat the corners of earlier ones", "triangles", get<&MeshReport::duplicate_triangles>},
    {"self_intersections", "triangle cuts or touches another one beside what they share",
     "triangles cut or touch another one beside what they share", "triangles", get_self_intersections},
    {"normals_not_unit", "normal does not have length 1", "normals do not have length 1", "vertices",
     get<&MeshReport::normals_not_unit>},
    {"normals_against", "corner has a normal that points behind its triangle",
     "corners have a normal that points behind their triangle", "triangles", get<&MeshReport::normals_against>},
    {"duplicate_vertices", "vertex repeats an earlier one", "vertices repeat an earlier one", "vertices",
     get<&MeshReport::duplicate_vertices>},
    {"unused_vertices", "vertex belongs to no triangle", "vertices belong to no triangle", "vertices",
     get<&MeshReport::unused_vertices>},
};

std::string sentence_of(const Wording& wording, const MeshFault& fault) {
  return fmt::format(
      "{} {} ({} {}{})", fault.count, fault.count == 1 ? wording.one : wording.many, wording.examples,
      fmt::join(fault.examples, ", "),
      fault.count > fault.examples.size() && fault.examples.size() == MeshFault::kExamples ? ", ..." : "");
}

/// A group of checks, and the findings that spoil it.
struct Use {
  std::string_view check, needs;
  std::vector<std::string_view> spoiled_by;
  bool wants_normals = false, wants_no_crossings = false;
};

const std::vector<Use>& uses() {
  static const std::vector<Use> table{
      {.check = "triangle",
       .needs = "triangles with area",
       .spoiled_by = {"triangles", "repeated_corners", "zero_area"}},
      {.check = "growth",
       .needs = "triangles with area, none twice; normals, if any, unit and in front",
       .spoiled_by = {"triangles", "repeated_corners", "zero_area", "duplicate_triangles", "normals_not_unit",
                      "normals_against"}},
      {.check = "smooth",
       .needs = "normals, unit and in front of triangles with area",
       .spoiled_by = {"triangles", "repeated_corners", "zero_area", "normals_not_unit", "normals_against"},
       .wants_normals = true},
      {.check = "inside",
       .needs = "closed, oriented outward",
       .spoiled_by = {"triangles", "boundary_edges", "edges_of_many", "misoriented_edges", "outward"}},
      {.check = "escape",
       .needs = "closed, manifold, oriented outward, triangles with area, no self-intersection",
       .spoiled_by = {"triangles", "boundary_edges", "edges_of_many", "misoriented_edges", "vertices_of_many_fans",
                      "repeated_corners", "zero_area", "duplicate_triangles", "self_intersections", "outward"},
       .wants_no_crossings = true},
  };
  return table;
}

}  // namespace

void MeshFault::add(std::uint32_t index) {
  ++count;
  const auto place = std::ranges::lower_bound(examples, index);
  if (place != examples.end() && *place == index) return;
  if (examples.size() == kExamples) {
    if (place == examples.end()) return;
    // The largest makes room; what lies before it keeps its order.
    std::ranges::move_backward(place, examples.end() - 1, examples.end());
    *place = index;
    return;
  }
  examples.insert(place, index);
}

std::vector<MeshFinding> mesh_faults(const MeshReport& report) {
  std::vector<MeshFinding> list;
  if (report.triangles == 0) list.push_back({"triangles", "there is no triangle"});
  for (const Wording& wording : kWordings)
    if (const MeshFault* fault = wording.fault(report); fault && fault->count > 0)
      list.push_back({wording.id, sentence_of(wording, *fault)});
  if (report.outward == false)
    list.push_back({"outward", "the triangles face inward: the volume they enclose is not positive"});
  return list;
}

std::vector<MeshFitness> mesh_fitness(const MeshReport& report) {
  const std::vector<MeshFinding> found = mesh_faults(report);
  std::vector<MeshFitness> list;
  for (const Use& use : uses()) {
    std::vector<std::string> reasons;
    for (const MeshFinding& finding : found)
      if (std::ranges::find(use.spoiled_by, finding.id) != use.spoiled_by.end()) reasons.push_back(finding.sentence);
    if (use.wants_normals && !report.has_normals) reasons.emplace_back("there are no normals");
    if (use.wants_no_crossings && !report.self_intersections)
      reasons.emplace_back("self-intersections were not looked for");
    list.push_back({use.check, use.needs, reasons.empty(), fmt::format("{}", fmt::join(reasons, "; "))});
  }
  return list;
}

}  // namespace plumb

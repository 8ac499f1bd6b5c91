#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "meshes/read_mesh.h"
#include "meshes/validation/mesh_report.h"
#include "renderer/math/input_error.h"
#include "tools/plumb/arguments.h"
#include "tools/plumb/mesh/mesh_command.h"
#include "tools/plumb/progress_bar.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

struct Arguments {
  std::vector<std::string> files;
  std::string use;
  bool json = false;
  bool no_self_intersections = false;
};

std::vector<std::string_view> use_names() {
  std::vector<std::string_view> names;
  for (const MeshFitness& use : mesh_fitness({})) names.push_back(use.check);
  return names;
}

std::string point_text(const Point3& p) { return fmt::format("({}, {}, {})", p.x, p.y, p.z); }

/// `closed, manifold, oriented outward`, or what of it does not hold.
std::string shape_text(const MeshReport& report) {
  std::string text = report.closed ? "closed" : "not closed";
  text += report.manifold ? ", manifold" : ", not manifold";
  text += report.oriented ? ", oriented" : ", not oriented";
  if (report.outward) text += *report.outward ? " outward" : " inward";
  return text;
}

void print_text(const std::string& file, const MeshReport& report) {
  fmt::print("{}: {} vertices, {} triangles, {} edges, {} component{}, Euler characteristic {}\n", file,
             report.vertices, report.triangles, report.edges, report.components, report.components == 1 ? "" : "s",
             report.euler_characteristic);
  if (!report.bounds.empty())
    fmt::print("  box: {} to {}\n", point_text(report.bounds.min), point_text(report.bounds.max));
  fmt::print("  {}; {} normals, {} texture coordinates\n", shape_text(report), report.has_normals ? "with" : "without",
             report.has_texcoords ? "with" : "without");
  if (report.seam_vertices.count > 0)
    fmt::print("  {} vertices stand where an earlier one does, with another normal or texture coordinate: a seam\n",
               report.seam_vertices.count);
  if (!report.self_intersections) fmt::print("  self-intersections were not looked for\n");
  const std::vector<MeshFinding> faults = mesh_faults(report);
  for (const MeshFinding& fault : faults) fmt::print("  fault: {}\n", fault.sentence);
  if (faults.empty()) fmt::print("  no fault\n");
  for (const MeshFitness& use : mesh_fitness(report)) {
    if (use.fit)
      fmt::print("  fit for {} checks\n", use.check);
    else
      fmt::print("  not fit for {} checks, which need: {}\n", use.check, use.needs);
  }
}

Json point_json(const Point3& p) { return Json{p.x, p.y, p.z}; }
Json fault_json(const MeshFault& fault) { return Json{{"count", fault.count}, {"examples", fault.examples}}; }

Json report_json(const std::string& file, const MeshReport& report) {
  Json json{{"file", file},
            {"vertices", report.vertices},
            {"triangles", report.triangles},
            {"edges", report.edges},
            {"components", report.components},
            {"euler_characteristic", report.euler_characteristic},
            {"bounds", nullptr},
            {"closed", report.closed},
            {"manifold", report.manifold},
            {"oriented", report.oriented},
            {"outward", nullptr},
            {"has_normals", report.has_normals},
            {"has_texcoords", report.has_texcoords}};
  if (!report.bounds.empty())
    json["bounds"] = {{"min", point_json(report.bounds.min)}, {"max", point_json(report.bounds.max)}};
  if (report.outward) json["outward"] = *report.outward;
  for (const auto& [name, field] : {std::pair{"boundary_edges", &MeshReport::boundary_edges},
                                    {"edges_of_many", &MeshReport::edges_of_many},
                                    {"misoriented_edges", &MeshReport::misoriented_edges},
                                    {"vertices_of_many_fans", &MeshReport::vertices_of_many_fans},
                                    {"repeated_corners", &MeshReport::repeated_corners},
                                    {"zero_area", &MeshReport::zero_area},
                                    {"duplicate_triangles", &MeshReport::duplicate_triangles},
                                    {"duplicate_vertices", &MeshReport::duplicate_vertices},
                                    {"seam_vertices", &MeshReport::seam_vertices},
                                    {"unused_vertices", &MeshReport::unused_vertices},
                                    {"normals_not_unit", &MeshReport::normals_not_unit},
                                    {"normals_against", &MeshReport::normals_against}})
    json[name] = fault_json(report.*field);
  json["self_intersections"] = report.self_intersections ? fault_json(*report.self_intersections) : Json(nullptr);
  json["faults"] = Json::array();
  for (const MeshFinding& fault : mesh_faults(report))
    json["faults"].push_back({{"id", fault.id}, {"sentence", fault.sentence}});
  for (const MeshFitness& use : mesh_fitness(report))
    json["fitness"][std::string(use.check)] = {{"fit", use.fit}, {"needs", use.needs}, {"reason", use.reason}};
  return json;
}

MeshReport checked(const std::string& file, bool self_intersections) {
  const TriangleMesh mesh = read_mesh(file);
  ProgressBar bar(file);
  return check_mesh(mesh,
                    {.self_intersections = self_intersections, .progress = [&](double share) { bar.show(share); }});
}

bool is_good(const MeshReport& report, const std::string& use) {
  if (use.empty()) return mesh_faults(report).empty();
  const std::vector<MeshFitness> fitness = mesh_fitness(report);
  return std::ranges::any_of(fitness, [&](const MeshFitness& one) { return one.check == use && one.fit; });
}

/// 0 if all are good, 1 if one is not, 2 if one cannot be read; the others are checked all the same.
int run(const Arguments& arguments) {
  if (!arguments.use.empty()) parse_choice("--for", arguments.use, use_names());
  int status = 0;
  Json meshes = Json::array();
  for (const std::string& file : arguments.files) {
    try {
      const MeshReport report = checked(file, !arguments.no_self_intersections);
      if (!is_good(report, arguments.use)) status = std::max(status, 1);
      if (arguments.json)
        meshes.push_back(report_json(file, report));
      else
        print_text(file, report);
    } catch (const InputError& error) {
      status = 2;
      fmt::print(stderr, "{}\n", error.what());
      if (arguments.json) meshes.push_back({{"file", file}, {"error", error.what()}});
    }
  }
  if (arguments.json) fmt::print("{}\n", Json{{"schema", 1}, {"meshes", meshes}}.dump(2));
  return status;
}

}  // namespace

void add_mesh_check(CLI::App& mesh, Action& action) {
  CLI::App* command = mesh.add_subcommand(
      "check", "Is a mesh closed, manifold, oriented, free of degenerate triangles and self-intersections?");
  const auto arguments = std::make_shared<Arguments>();
  Arguments& a = *arguments;
  command->add_option("files", a.files, "Meshes: .msh, .obj, .ply, .off, .stl")->required()->type_name("FILE");
  command->add_option("--for", a.use, "Exit 0 if fit for these checks, whatever else is wrong: " + joined(use_names()))
      ->type_name("CHECKS");
  command->add_flag("--no-self-intersections", a.no_self_intersections, "Skip what takes longest");
  command->add_flag("--json", a.json, "The same facts as JSON");
  command->callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace plumb

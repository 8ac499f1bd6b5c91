#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "meshes/read_mesh.h"
#include "tools/plumb/mesh/mesh_command.h"

namespace plumb {
namespace {

struct Arguments {
  std::vector<std::string> files;
  bool json = false;
};

struct Box {
  Point3 least, most;
};

/// Of all vertices, also those of no triangle; nullopt without any.
std::optional<Box> bounds_of(const TriangleMesh& mesh) {
  if (mesh.positions.empty()) return std::nullopt;
  Box box{mesh.positions[0], mesh.positions[0]};
  for (const Point3& p : mesh.positions) {
    box.least = {std::min(box.least.x, p.x), std::min(box.least.y, p.y), std::min(box.least.z, p.z)};
    box.most = {std::max(box.most.x, p.x), std::max(box.most.y, p.y), std::max(box.most.z, p.z)};
  }
  return box;
}

struct Facts {
  std::string file;
  std::uintmax_t bytes = 0;
  std::size_t vertices = 0, triangles = 0;
  bool normals = false, texcoords = false;
  std::optional<Box> bounds;
  MeshNotes notes;
};

Facts facts_of(const std::string& file) {
  Facts facts;
  const TriangleMesh mesh = read_mesh(file, &facts.notes);
  facts.file = file;
  facts.bytes = std::filesystem::file_size(file);
  facts.vertices = mesh.positions.size();
  facts.triangles = mesh.triangles.size();
  facts.normals = !mesh.normals.empty();
  facts.texcoords = !mesh.texcoords.empty();
  facts.bounds = bounds_of(mesh);
  return facts;
}

void print_text(const Facts& facts) {
  fmt::print("{}: {}, {} bytes\n", facts.file, facts.notes.format, facts.bytes);
  fmt::print("  {}, {}, {}normals, {}texture coordinates\n", counted(facts.vertices, "vertex", "vertices"),
             counted(facts.triangles, "triangle", "triangles"), facts.normals ? "" : "no ",
             facts.texcoords ? "" : "no ");
  if (facts.bounds) {
    const auto& [a, b] = *facts.bounds;
    fmt::print("  from ({}, {}, {}) to ({}, {}, {})\n", a.x, a.y, a.z, b.x, b.y, b.z);
  }
  for (const std::string& sentence : facts.notes.sentences) fmt::print("  note: {}\n", sentence);
}

nlohmann::ordered_json to_json(const Facts& facts) {
  const auto triple = [](const Point3& p) { return std::array{p.x, p.y, p.z}; };
  nlohmann::ordered_json bounds;
  if (facts.bounds) bounds = {{"min", triple(facts.bounds->least)}, {"max", triple(facts.bounds->most)}};
  return {{"file", facts.file},
          {"format", facts.notes.format},
          {"bytes", facts.bytes},
          {"vertices", facts.vertices},
          {"triangles", facts.triangles},
          {"normals", facts.normals},
          {"texcoords", facts.texcoords},
          {"polygons", facts.notes.polygons},
          {"bounds", bounds},
          {"notes", facts.notes.sentences}};
}

int run(const Arguments& arguments) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const std::string& file : arguments.files) {
    const Facts facts = facts_of(file);
    arguments.json ? all.push_back(to_json(facts)) : print_text(facts);
  }
  if (arguments.json) {
    // A name need not be UTF-8, of which JSON is made.
    fmt::print("{}\n", all.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  }
  return 0;
}

}  // namespace

void add_mesh_info(CLI::App& mesh, Action& action) {
  CLI::App* command = mesh.add_subcommand("info", "What mesh files hold, and what of it is not read");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("files", arguments->files, "A .msh, .obj, .ply, .off or .stl file")
      ->required()
      ->type_name("FILE...");
  command->add_flag("--json", arguments->json, "One JSON array, an object a file");
  command->callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace plumb

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "meshes/generators/mesh_kind.h"
#include "renderer/math/input_error.h"
#include "tools/plumb/mesh/mesh_command.h"
#include "tools/plumb/progress_bar.h"

namespace plumb {
namespace {

struct Options {
  std::string family, file;
  std::uint64_t triangles = 1000, seed = 1;
  bool list = false, text = false;
};

int list() {
  for (const MeshKind* kind : mesh_kinds()) {
    fmt::print("{:<17} {:<6} {:<6} {}\n", kind->id, kind->closed ? "closed" : "open", kind->random ? "random" : "",
               kind->description);
  }
  return 0;
}

int generate(const Options& options) {
  if (options.list) return list();
  if (options.family.empty())
    throw InputError({}, "no mesh family is named; expected one of plumb mesh generate --list");
  const MeshKind& kind = mesh_kind(options.family);
  if (options.file.empty()) throw InputError({}, "no file is named; expected -o FILE");
  TriangleMesh mesh;
  {
    ProgressBar bar("generating");
    mesh = kind.make({options.triangles, options.seed, [&](double share) { bar.show(share); }});
  }
  write_and_report(mesh, options.file, options.text);
  return 0;
}

}  // namespace

void add_mesh_generate(CLI::App& mesh, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* verb = mesh.add_subcommand("generate", "Make a mesh of a family, the same bytes on every machine");
  verb->add_option("FAMILY", options->family, "One of those that --list names");
  verb->add_option("-o,--output", options->file, "The mesh file: .msh, .obj, .ply, .off or .stl");
  verb->add_option("--triangles", options->triangles,
                   "How many triangles, from 1 to 100000000: the family's nearest number that is not less")
      ->capture_default_str();
  verb->add_option("--seed", options->seed, "Of the families that are random")->capture_default_str();
  verb->add_flag("--text", options->text, "Text where the format has both text and binary");
  verb->add_flag("--list", options->list, "Name the families: closed or open, random or not");
  verb->callback([options, &action] { action = [options] { return generate(*options); }; });
}

}  // namespace plumb

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "meshes/read_mesh.h"
#include "meshes/write_mesh.h"
#include "renderer/image/staged_file.h"
#include "tools/plumb/mesh/mesh_command.h"

namespace plumb {
namespace {

struct Arguments {
  std::string in, out;
  bool text = false;
};

int run(const Arguments& arguments) {
  require_mesh_ending(arguments.out);
  require_writable(arguments.out);
  MeshNotes notes;
  const TriangleMesh mesh = read_mesh(arguments.in, &notes);
  for (const std::string& sentence : notes.sentences) fmt::print("{}: {}\n", arguments.in, sentence);
  write_and_report(mesh, arguments.out, arguments.text);
  return 0;
}

}  // namespace

void add_mesh_convert(CLI::App& mesh, Action& action) {
  CLI::App* command = mesh.add_subcommand("convert", "Write a mesh in another format, and say what is lost");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("in", arguments->in, "A .msh, .obj, .ply, .off or .stl file")->required()->type_name("IN");
  command->add_option("out", arguments->out, "The file to write, its format by its ending; may be IN")
      ->required()
      ->type_name("OUT");
  command->add_flag("--text", arguments->text, "Text, where the format is binary otherwise (PLY, OFF, STL)");
  command->callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace plumb

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <optional>

#include "meshes/editing/vertex_normals.h"
#include "meshes/read_mesh.h"
#include "renderer/math/input_error.h"
#include "tools/plumb/arguments.h"
#include "tools/plumb/mesh/edit_arguments.h"
#include "tools/plumb/mesh/mesh_command.h"

namespace plumb {
namespace {

constexpr std::array<std::string_view, 2> kWeights = {"area", "angle"};

struct Arguments : EditArguments {
  std::string weight = "area";
  std::optional<double> crease;
  bool remove = false, flip = false;
};

void smooth(TriangleMesh& mesh, const Arguments& a, NormalWeight weight) {
  if (a.crease) {
    const std::size_t added = split_at_creases(mesh, *a.crease);
    fmt::print("creases: {} vertices repeated where triangles meet at more than {} degrees\n", added, *a.crease);
  }
  const std::size_t without = compute_normals(mesh, weight);
  if (without > 0) fmt::print("normals: (0, 0, 1) at {} vertices that no triangle with an area gives one\n", without);
}

int run(const Arguments& a) {
  const std::size_t weight = parse_choice("--weight", a.weight, kWeights);
  if (a.crease && !(*a.crease >= 0 && *a.crease <= 180))
    throw InputError({}, fmt::format("--crease {}: expected degrees from 0 to 180", *a.crease));
  TriangleMesh mesh = read_mesh(a.in);
  if (a.remove)
    mesh.normals.clear();
  else if (a.flip)
    flip(mesh);
  else
    smooth(mesh, a, weight == 0 ? NormalWeight::kArea : NormalWeight::kAngle);
  write_and_report(mesh, a.out, a.text);
  return 0;
}

}  // namespace

void add_mesh_normals(CLI::App& mesh, Action& action) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      add_edit_verb(mesh, "normals", "Compute smooth normals, remove them, or turn the mesh inside out", *arguments);
  CLI::Option* weight =
      command->add_option("--weight", arguments->weight, "What a triangle counts at its vertex [area]")
          ->type_name(joined(kWeights));
  CLI::Option* crease =
      command
          ->add_option("--crease", arguments->crease, "Repeat vertices where triangles meet at more than this [never]")
          ->type_name("DEGREES");
  CLI::Option* remove = command->add_flag("--remove", arguments->remove, "Write the mesh without normals")
                            ->excludes(weight)
                            ->excludes(crease);
  command->add_flag("--flip", arguments->flip, "Reverse all triangles, and the normals that are there")
      ->excludes(weight)
      ->excludes(crease)
      ->excludes(remove);
  command->callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace plumb

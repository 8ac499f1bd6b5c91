#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

#include "meshes/editing/transform_mesh.h"
#include "meshes/read_mesh.h"
#include "renderer/math/input_error.h"
#include "tools/plumb/arguments.h"
#include "tools/plumb/mesh/edit_arguments.h"
#include "tools/plumb/mesh/mesh_command.h"

namespace plumb {
namespace {

/// What one option adds, given the mesh and what came before it.
using Step = std::function<AffineMatrix(const TriangleMesh& mesh, const AffineMatrix& before)>;

struct Arguments : EditArguments {
  /// In the order of the command line.
  std::vector<Step> steps;
};

Step fixed(const AffineMatrix& matrix) {
  return [matrix](const TriangleMesh&, const AffineMatrix&) { return matrix; };
}

Vec3 parse_triple(const char* option, const std::string& text) {
  const std::vector<double> n = parse_numbers(option, text, 3);
  return {n[0], n[1], n[2]};
}

AffineMatrix parse_scale(const std::string& text) {
  if (text.find_first_of(", ") != std::string::npos) return scaling(parse_triple("--scale", text));
  const double factor = parse_numbers("--scale", text, 1).front();
  return scaling({factor, factor, factor});
}

AffineMatrix parse_matrix(const std::string& text) {
  const std::vector<double> numbers = parse_numbers("--matrix", text, 12);
  AffineMatrix matrix;
  for (std::size_t i = 0; i < 12; ++i) matrix[i / 4][i % 4] = numbers[i];
  return matrix;
}

AffineMatrix fit_unit_cube(const TriangleMesh& mesh, const AffineMatrix& before) {
  const Bounds3 box = bounds_of(mesh, before);
  const Vec3 sides = box.max - box.min;
  const double longest = std::max({sides.x, sides.y, sides.z});
  if (!(longest > 0) || !std::isfinite(longest) || !std::isfinite(1 / longest))
    throw InputError({}, "--fit-unit-cube: the mesh is empty, a point or too large; expected one with an extent");
  return unit_cube_from(box);
}

int run(const Arguments& a) {
  if (a.steps.empty())
    throw InputError({}, "nothing is asked, expected --translate, --rotate, --scale, --matrix or --fit-unit-cube");
  TriangleMesh mesh = read_mesh(a.in);
  bool is_mirrored = false;
  try {
    AffineMatrix matrix = identity_matrix();
    for (const Step& step : a.steps) matrix = step(mesh, matrix) * matrix;
    mesh = transformed(std::move(mesh), Transform(matrix));
    is_mirrored = is_mirroring(matrix);
  } catch (const SingularTransform& error) {
    throw InputError({}, fmt::format("{}; expected one that has an inverse", error.what()));
  } catch (const std::range_error& error) {
    throw InputError({a.in}, fmt::format("{}; expected a smaller transform", error.what()));
  }
  write_and_report(mesh, a.out, a.text);
  if (is_mirrored) fmt::print("mirrored: every triangle is reversed, so that its front stays on the outside\n");
  return 0;
}

}  // namespace

void add_mesh_transform(CLI::App& mesh, Action& action) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = add_edit_verb(
      mesh, "transform", "Move, turn, scale or mirror; the options apply one after another, as given", *arguments);
  const auto add_step = [&](const char* option, const char* type, const char* what,
                            std::function<Step(const std::string&)> parse) {
    command
        ->add_option_function<std::vector<std::string>>(
            option,
            [arguments, parse](const std::vector<std::string>& given) {
              arguments->steps.push_back(parse(given.back()));
            },
            what)
        ->type_name(type)
        ->expected(1)
        ->trigger_on_parse();
  };
  add_step("--translate", "X,Y,Z", "Move",
           [](const std::string& text) { return fixed(translation(parse_triple("--translate", text))); });
  add_step("--rotate", "X,Y,Z", "Turn about x, then y, then z, in degrees",
           [](const std::string& text) { return fixed(rotation_degrees(parse_triple("--rotate", text))); });
  add_step("--scale", "S or X,Y,Z", "Multiply the coordinates",
           [](const std::string& text) { return fixed(parse_scale(text)); });
  add_step("--matrix", "12 NUMBERS", "Apply the upper three rows of a matrix",
           [](const std::string& text) { return fixed(parse_matrix(text)); });
  command
      ->add_flag_function(
          "--fit-unit-cube", [arguments](std::int64_t) { arguments->steps.push_back(fit_unit_cube); },
          "Move the middle to the origin and make the longest side 1")
      ->trigger_on_parse();
  command->callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace plumb

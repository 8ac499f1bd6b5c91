#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <memory>
#include <stdexcept>

#include "conformance/checks/describe.h"
#include "reference/exact_bounds.h"
#include "reference/exact_hit.h"
#include "reference/exact_transform.h"
#include "reference/explain.h"
#include "renderer/math/input_error.h"
#include "tools/plumb/arguments.h"
#include "tools/plumb/command.h"

namespace plumb {
namespace {

/// The texts as they stand on the command line.
struct Arguments {
  std::string triangle, sphere, box, cylinder, cone, matrix;
  std::string origin, direction, range = "0,inf", claimed;
  /// translate, rotate and scale in the order in which they were given.
  std::vector<TransformStep> steps;
};

template <class Triple>
Triple triple(const std::vector<double>& numbers, std::size_t from = 0) {
  return {numbers[from], numbers[from + 1], numbers[from + 2]};
}

Shape shape_of(const Arguments& a) {
  Shape shape;
  int given = 0;
  const auto read = [&](const std::string& text, std::string_view option, ShapeKind kind, std::size_t count) {
    if (text.empty()) return std::vector<double>();
    ++given;
    shape.kind = kind;
    return parse_numbers(option, text, count);
  };
  if (const auto n = read(a.triangle, "--triangle", ShapeKind::triangle, 9); !n.empty())
    shape.vertices = {triple<Point3>(n, 0), triple<Point3>(n, 3), triple<Point3>(n, 6)};
  if (const auto n = read(a.sphere, "--sphere", ShapeKind::sphere, 4); !n.empty()) {
    shape.center = triple<Point3>(n);
    shape.radius = n[3];
  }
  if (const auto n = read(a.box, "--box", ShapeKind::box, 6); !n.empty()) {
    shape.min = triple<Point3>(n, 0);
    shape.max = triple<Point3>(n, 3);
  }
  if (const auto n = read(a.cylinder, "--cylinder", ShapeKind::cylinder, 5); !n.empty()) {
    shape.center = triple<Point3>(n);
    shape.radius = n[3];
    shape.height = n[4];
  }
  if (const auto n = read(a.cone, "--cone", ShapeKind::cone, 6); !n.empty()) {
    shape.center = triple<Point3>(n);
    shape.tip_z = n[3];
    shape.radius = n[4];
    shape.height = n[5];
  }
  if (given != 1)
    throw InputError(
        {},
        fmt::format("{} surfaces are given, expected one of --triangle, --sphere, --box, --cylinder, --cone", given));
  return shape;
}

PlacedShape placed_of(const Arguments& a) {
  PlacedShape placed{.shape = shape_of(a)};
  if (a.matrix.empty()) return placed;
  const std::vector<double> numbers = parse_numbers("--matrix", a.matrix, 12);
  for (std::size_t i = 0; i < 12; ++i) placed.world_from_object[i / 4][i % 4] = numbers[i];
  return placed;
}

void print(const Explanation& explanation) {
  std::size_t width = 4;
  for (const ExplainedNumber& n : explanation.numbers) width = std::max(width, n.name.size());
  for (const ExplainedNumber& n : explanation.numbers) {
    fmt::print("{:<{}}  {}  {}\n", n.name, width, n.sign > 0 ? '+' : n.sign < 0 ? '-' : '0', n.formula);
    fmt::print("{:<{}}     = {}\n", "", width, n.decimal);
    if (n.fraction != n.decimal && n.fraction.size() <= 2000)
      fmt::print("{:<{}}     = {} exactly\n", "", width, n.fraction);
  }
  for (const std::string& step : explanation.steps) fmt::print("- {}\n", step);
}

void print(const ExactHit& hit) {
  fmt::print("\nanswer: {}\n", describe(hit));
  for (const ExactCrossing& c : hit.crossings) {
    if (c.t.exact())
      fmt::print("  t = {} exactly\n", hex(c.t.below));
    else
      fmt::print("  t in {} .. {}\n", hex(c.t.below), hex(c.t.above));
    fmt::print("    nearest double {} ({:.17g}), nearest float {} ({:.9g})\n", hex(c.t_double), c.t_double,
               hex(static_cast<double>(c.t_float)), c.t_float);
    fmt::print("    at ({:.17g}, {:.17g}, {:.17g}), normal ({:.17g}, {:.17g}, {:.17g})\n", c.position.x, c.position.y,
               c.position.z, c.normal.x, c.normal.y, c.normal.z);
    if (c.free) fmt::print("    free: a program may report it or not\n");
    if (c.place != RangePlace::within)
      fmt::print("    exactly at {}\n", c.place == RangePlace::at_min ? "t_min" : "t_max");
  }
}

int ask_ray(const Arguments& a) {
  const PlacedShape placed = placed_of(a);
  const std::vector<double> range = parse_numbers("--range", a.range, 2);
  const Ray ray{triple<Point3>(parse_numbers("--origin", a.origin, 3)),
                triple<Vec3>(parse_numbers("--direction", a.direction, 3)), range[0], range[1]};
  const ExactHit hit = exact_hit(placed, ray);
  if (hit.hit_class == HitClass::unsupported)
    throw InputError(
        {},
        "outside of what the oracle knows: a number that is not finite, a direction of zero, an empty range, a "
        "negative radius or height, a box with min > max, or a cone with its tip at its centre's height");
  if (hit.hit_class != HitClass::singular) print(explain_ray(placed, ray));
  print(hit);
  return 0;
}

int ask_bounds(const Arguments& a) {
  const PlacedShape placed = placed_of(a);
  print(explain_bounds(placed));
  if (a.claimed.empty()) return 0;
  const std::vector<double> six = parse_numbers("--claimed", a.claimed, 6);
  const BoundsVerdict verdict = judge_bounds(placed, {triple<Point3>(six, 0), triple<Point3>(six, 3)});
  fmt::print("\nanswer: the claimed box {}\n", verdict.contains ? "contains the surface" : "CUTS the surface");
  constexpr std::array<const char*, 6> kFaces{"min x", "min y", "min z", "max x", "max y", "max z"};
  for (std::size_t i = 0; i < 6; ++i)
    fmt::print("  {}: {}\n", kFaces[i],
               verdict.ulps_loose[i] == 0  ? "tight"
               : verdict.ulps_loose[i] > 0 ? fmt::format("{} doubles loose", verdict.ulps_loose[i])
                                           : fmt::format("{} doubles too far inside", -verdict.ulps_loose[i]));
  return verdict.contains ? 0 : 1;
}

template <std::size_t columns>
void print(const char* name, const std::array<std::array<Enclosure, columns>, 3>& matrix) {
  fmt::print("{}\n", name);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      const Enclosure& e = matrix[i][j];
      fmt::print("  [{},{}] {} {:.17g} ({}){}\n", i, j, e.exact() ? "=" : "~", e.below, hex(e.below),
                 e.exact() ? "" : " or the next double");
    }
  }
}

int ask_matrix(const Arguments& a) {
  EnclosedMatrix inverse;
  if (!a.matrix.empty()) {
    const std::vector<double> numbers = parse_numbers("--matrix", a.matrix, 12);
    AffineMatrix matrix;
    for (std::size_t i = 0; i < 12; ++i) matrix[i / 4][i % 4] = numbers[i];
    EnclosedMatrix3 transpose;
    if (!certified_inverse(matrix, inverse)) {
      fmt::print("answer: the determinant is exactly 0; there is no inverse\n");
      return 0;
    }
    certified_inverse_transpose(matrix, transpose);
    print("inverse", inverse);
    print("inverse transpose", transpose);
    fmt::print("condition number {:.6g}\n", condition_number(matrix));
    return 0;
  }
  if (a.steps.empty())
    throw InputError({}, "nothing is asked, expected --matrix, or --translate, --rotate, --scale in file order");
  print("product, the first line outermost", certified_product(a.steps));
  if (certified_inverse(std::span<const TransformStep>(a.steps), inverse)) print("inverse", inverse);
  return 0;
}

void add_surface_options(CLI::App& app, Arguments& a) {
  app.add_option("--triangle", a.triangle, "Three vertices")->type_name("AX,AY,AZ,BX,..");
  app.add_option("--sphere", a.sphere, "Centre and radius")->type_name("X,Y,Z,R");
  app.add_option("--box", a.box, "Smallest and largest corner")->type_name("X,Y,Z,X,Y,Z");
  app.add_option("--cylinder", a.cylinder, "Centre, radius and height")->type_name("X,Y,Z,R,H");
  app.add_option("--cone", a.cone, "Centre, z of the tip, radius and height")->type_name("X,Y,Z,TIPZ,R,H");
  app.add_option("--matrix", a.matrix, "World from object: the upper three rows [identity]")->type_name("12 NUMBERS");
}

}  // namespace

void add_oracle_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("oracle", "Ask exact arithmetic about one ray, box or matrix, and see why");
  command->require_subcommand(1);
  const auto arguments = std::make_shared<Arguments>();
  Arguments& a = *arguments;
  // Numbers may be negative; CLI11 takes "-1,2" as a value where an option expects one.
  CLI::App* ray = command->add_subcommand("ray", "Where a ray meets a surface");
  add_surface_options(*ray, a);
  ray->add_option("--origin", a.origin, "Where the ray begins")->required()->type_name("X,Y,Z");
  ray->add_option("--direction", a.direction, "Of any length")->required()->type_name("X,Y,Z");
  ray->add_option("--range", a.range, "Closed range of t [0,inf]")->type_name("MIN,MAX");
  ray->callback([&action, arguments] { action = [arguments] { return ask_ray(*arguments); }; });

  CLI::App* bounds =
      command->add_subcommand("bounds", "The tightest world box of a surface; judges one that is claimed");
  add_surface_options(*bounds, a);
  bounds->add_option("--claimed", a.claimed, "A box to judge")->type_name("X,Y,Z,X,Y,Z");
  bounds->callback([&action, arguments] { action = [arguments] { return ask_bounds(*arguments); }; });

  CLI::App* matrix =
      command->add_subcommand("matrix", "The product of transforms in file order, or the inverse of a matrix");
  matrix->add_option("--matrix", a.matrix, "Invert these doubles: the upper three rows")->type_name("12 NUMBERS");
  const auto add_step = [&](const char* option, TransformStep::Kind kind, const char* what) {
    matrix
        ->add_option_function<std::vector<std::string>>(
            option,
            [arguments, option, kind](const std::vector<std::string>& given) {
              arguments->steps.push_back({kind, triple<Vec3>(parse_numbers(option, given.back(), 3))});
            },
            what)
        ->type_name("X,Y,Z")
        ->expected(1)
        ->trigger_on_parse();
  };
  add_step("--translate", TransformStep::Kind::translate, "A line of a group; give them in file order");
  add_step("--rotate", TransformStep::Kind::rotate, "Degrees about x, then y, then z");
  add_step("--scale", TransformStep::Kind::scale, "Along x, y, z");
  matrix->callback([&action, arguments] { action = [arguments] { return ask_matrix(*arguments); }; });
}

}  // namespace plumb

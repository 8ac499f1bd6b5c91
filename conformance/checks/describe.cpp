#include "conformance/checks/describe.h"

#include <fmt/format.h>

#include <cmath>

namespace plumb {
namespace {

template <class Triple>
std::string triple(const Triple& v) {
  return hex(v.x) + "," + hex(v.y) + "," + hex(v.z);
}

std::string shape_option(const Shape& shape) {
  switch (shape.kind) {
    case ShapeKind::triangle:
      return "--triangle " + triple(shape.vertices[0]) + "," + triple(shape.vertices[1]) + "," +
             triple(shape.vertices[2]);
    case ShapeKind::sphere:
      return "--sphere " + triple(shape.center) + "," + hex(shape.radius);
    case ShapeKind::box:
      return "--box " + triple(shape.min) + "," + triple(shape.max);
    case ShapeKind::cylinder:
      return "--cylinder " + triple(shape.center) + "," + hex(shape.radius) + "," + hex(shape.height);
    case ShapeKind::cone:
      return "--cone " + triple(shape.center) + "," + hex(shape.tip_z) + "," + hex(shape.radius) + "," +
             hex(shape.height);
    case ShapeKind::mesh:
      return "";
  }
  return "";
}

std::string matrix_option(const AffineMatrix& matrix) {
  if (matrix == identity_matrix()) return "";
  std::string text;
  for (const auto& row : matrix)
    for (const double entry : row) text += (text.empty() ? "" : ",") + hex(entry);
  return " --matrix " + text;
}

const char* class_name(HitClass hit_class) {
  switch (hit_class) {
    case HitClass::miss:
      return "miss";
    case HitClass::hit:
      return "hit";
    case HitClass::boundary:
      return "boundary";
    case HitClass::tangent:
      return "tangent";
    case HitClass::singular:
      return "singular matrix";
    case HitClass::unsupported:
      return "unsupported";
  }
  return "?";
}

}  // namespace

std::string hex(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return fmt::format("{:a}", value);
}

std::string describe(const SubjectHit& answer) {
  return answer.hit() ? fmt::format("hit at t = {} ({:.17g})", hex(answer.t), answer.t) : "miss";
}

std::string describe(const ExactHit& truth) {
  std::string text = class_name(truth.hit_class);
  if (!truth.crossings.empty()) {
    const ExactCrossing& first = truth.crossings.front();
    text += fmt::format(" at t = {} ({:.17g})", hex(first.t_double), first.t_double);
  }
  return truth.inside ? text + ", from inside" : text;
}

std::string oracle_command(const PlacedShape& placed, const Ray& ray) {
  if (placed.shape.kind == ShapeKind::mesh)
    return fmt::format("(a mesh of {} triangles) --origin {} --direction {}", placed.shape.mesh->triangles.size(),
                       triple(ray.origin), triple(ray.direction));
  return fmt::format("plumb oracle ray {}{} --origin {} --direction {} --range {},{}", shape_option(placed.shape),
                     matrix_option(placed.world_from_object), triple(ray.origin), triple(ray.direction), hex(ray.t_min),
                     hex(ray.t_max));
}

}  // namespace plumb

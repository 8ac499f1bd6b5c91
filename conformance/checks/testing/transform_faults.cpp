#include <algorithm>
#include <cmath>
#include <numbers>

#include "conformance/checks/testing/planted_fault.h"
#include "conformance/families/placed.h"

namespace plumb::planted {
namespace {

/// The same surface with other groups, its matrix their product.
SubjectSurface with_groups(SubjectSurface surface, Groups groups) {
  surface.world_from_object = product_of(groups);
  surface.groups = std::move(groups);
  return surface;
}

/// A subject whose world matrices are products of groups that were changed by `change`, and otherwise right.
template <class Change>
std::function<std::unique_ptr<Subject>()> multiplied(Change change) {
  return spoiled([=](Formulas& f) {
    f.matrices = [=, right = f.matrices](const SubjectSurface& s) {
      Groups groups = s.groups;
      change(groups);
      return right(with_groups(s, std::move(groups)));
    };
  });
}

void reverse_lines(Groups& groups) {
  for (auto& group : groups) std::ranges::reverse(group);
}
void reverse_groups(Groups& groups) { std::ranges::reverse(groups); }
void reverse_all(Groups& groups) {
  reverse_lines(groups);
  reverse_groups(groups);
}

/// Rx Ry Rz, as three lines.
void rotate_about_z_first(Groups& groups) {
  for (auto& group : groups) {
    std::vector<TransformStep> steps;
    for (const TransformStep& step : group) {
      if (step.kind != TransformStep::Kind::rotate) {
        steps.push_back(step);
        continue;
      }
      for (int axis = 0; axis < 3; ++axis) {
        TransformStep one{TransformStep::Kind::rotate, {}};
        one.value[axis] = step.value[axis];
        steps.push_back(one);
      }
    }
    group = std::move(steps);
  }
}

/// Degrees to radians by a short pi: each angle is off by 8e-7 of itself.
void short_pi(Groups& groups) {
  for (auto& group : groups)
    for (TransformStep& step : group)
      if (step.kind == TransformStep::Kind::rotate) step.value = (3.14159 / std::numbers::pi) * step.value;
}

Ray with_unit_direction(const AffineMatrix& m, const Ray& ray) {
  Ray own = Transform(m).inverse_of(ray);
  own.direction = normalized(own.direction);
  return own;
}

/// The inverse in float, as where a renderer's structures hold it so.
Ray by_float_inverse(const AffineMatrix& m, const Ray& ray) {
  AffineMatrix inverse = Transform(m).inverse_matrix();
  for (auto& row : inverse)
    for (double& entry : row) entry = static_cast<double>(static_cast<float>(entry));
  return Transform(inverse)(ray);
}

Vec3 flipped_where_mirrored(const AffineMatrix& m, const Normal3& n) {
  const Transform t(m);
  const Vec3 x = t(Vec3{1, 0, 0}), y = t(Vec3{0, 1, 0}), z = t(Vec3{0, 0, 1});
  return (dot(cross(x, y), z) < 0 ? -1.0 : 1.0) * as_vector(t(n));
}

std::array<std::array<double, 3>, 3> linear_part(const AffineMatrix& m) {
  std::array<std::array<double, 3>, 3> part{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) part[i][j] = m[i][j];
  return part;
}

/// As for a rotation.
SubjectMatrices inverse_by_transposing(SubjectMatrices right) {
  const AffineMatrix& m = right.world_from_object;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) right.inverse[i][j] = m[j][i];
    right.inverse[i][3] = -(m[0][i] * m[0][3] + m[1][i] * m[1][3] + m[2][i] * m[2][3]);
  }
  return right;
}

SubjectMatrices inverse_not_transposed(SubjectMatrices right) {
  right.inverse_transpose = linear_part(right.inverse);
  return right;
}

template <class Change>
std::function<std::unique_ptr<Subject>()> reported(Change change) {
  return spoiled(
      [=](Formulas& f) { f.matrices = [=, right = f.matrices](const SubjectSurface& s) { return change(right(s)); }; });
}

}  // namespace

std::vector<Fault> transform_faults() {
  const auto kernel = [](auto into_object) {
    return spoiled([=](Formulas& f) {
      f.contract.matrices = false;
      f.into_object = into_object;
    });
  };
  return {
      {"M0", "the transformed direction is made unit, which changes t", Verdict::fail, "t_normalised",
       kernel(with_unit_direction)},
      {"M1", "the transformed direction is made unit, which changes t", Verdict::fail, "t_normalised",
       kernel(with_unit_direction)},
      {"M1", "the inverse is held in float", Verdict::fail, "class", kernel(by_float_inverse)},
      {"M2", "normals carried by the matrix", Verdict::fail, "normal", spoiled([](Formulas& f) {
         f.normal_to_world = [](const AffineMatrix& m, const Normal3& n) { return Transform(m)(as_vector(n)); };
       }),
       Right::formulas},
      {"M3", "normals turned over with the winding", Verdict::fail, "normal",
       spoiled([](Formulas& f) { f.normal_to_world = flipped_where_mirrored; }), Right::formulas},
      {"M4", "pi is 3.14159", Verdict::fail, "world", multiplied(short_pi), Right::formulas},
      {"matrices", "rotations about z first", Verdict::fail, "rotation_order", multiplied(rotate_about_z_first),
       Right::formulas},
      {"matrices", "the lines of a group from the last to the first", Verdict::fail, "order", multiplied(reverse_lines),
       Right::formulas},
      {"matrices", "everything from the last to the first", Verdict::fail, "order", multiplied(reverse_all),
       Right::formulas},
      {"matrices", "groups from the inside", Verdict::fail, "group_order", multiplied(reverse_groups), Right::formulas},
      {"matrices", "the transpose for the inverse, as of a rotation", Verdict::fail, "inverse",
       reported(inverse_by_transposing), Right::formulas},
      {"matrices", "the inverse, not transposed, for normals", Verdict::fail, "inverse_transpose",
       reported(inverse_not_transposed), Right::formulas},
  };
}

}  // namespace plumb::planted

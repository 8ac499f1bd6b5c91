#pragma once

#include <array>
#include <cmath>
#include <random>
#include <string>

#include "reference/shape.h"

namespace plumb {

/// Placed shapes drawn at random for the tests of bounds, the same for the same seed on every machine.
class PlacedShapeCases {
 public:
  /// How the matrix and the numbers are made.
  enum class Style {
    nested,    ///< products of one to eight translations, rotations, shears and scalings, mirrored ones among them
    lattice,   ///< small integers: exact roots, faces that are doubles, equal candidates
    singular,  ///< a row, a column or a whole matrix of zeros, or of rank 1
    steep,     ///< a condition number of up to 1e12
    extreme,   ///< exponents from the smallest denormal to 2^300 and more, mixed
  };
  static constexpr std::array kStyles{Style::nested, Style::lattice, Style::singular, Style::steep, Style::extreme};
  static constexpr std::array kKinds{ShapeKind::triangle, ShapeKind::sphere, ShapeKind::box,
                                     ShapeKind::cylinder, ShapeKind::cone,   ShapeKind::mesh};

  explicit PlacedShapeCases(std::uint64_t seed) : random_(seed) {}

  PlacedShape next(ShapeKind kind, Style style) {
    style_ = style;
    PlacedShape placed;
    Shape& shape = placed.shape;
    shape.kind = kind;
    for (Point3& vertex : shape.vertices) vertex = point();
    shape.center = point();
    shape.radius = std::fabs(number());
    shape.height = std::fabs(number());
    shape.tip_z = number();
    if (shape.tip_z == shape.center.z) shape.tip_z = shape.center.z == 0 ? 1 : 2 * shape.center.z;
    shape.min = point();
    shape.max = point();
    for (int axis = 0; axis < 3; ++axis)
      if (shape.min[axis] > shape.max[axis]) std::swap(shape.min[axis], shape.max[axis]);
    if (kind == ShapeKind::mesh) shape.mesh = mesh();
    placed.world_from_object = matrix();
    return placed;
  }

  double uniform(double low, double high) {
    // Of 53 random bits; std::uniform_real_distribution may differ between libraries.
    return low + (high - low) * (static_cast<double>(random_() >> 11) * 0x1p-53);
  }
  int integer(int low, int high) {
    return low + static_cast<int>(random_() % static_cast<std::uint64_t>(high - low + 1));
  }

  double number() {
    switch (style_) {
      case Style::lattice:
        return integer(-6, 6);
      case Style::extreme:
        return std::ldexp(uniform(-1, 1), integer(0, 3) == 0 ? integer(-1073, -900) : integer(-400, 300));
      default:
        return uniform(-10, 10);
    }
  }
  Point3 point() { return {number(), number(), number()}; }

 private:
  std::shared_ptr<TriangleMesh> mesh() {
    auto mesh = std::make_shared<TriangleMesh>();
    const int count = integer(3, 12);
    for (int i = 0; i < count; ++i) mesh->positions.push_back(point());
    // The last vertex stays unused, and far away.
    mesh->positions.push_back({1e9, -1e9, 1e9});
    const auto index = [&] { return static_cast<std::uint32_t>(integer(0, count - 1)); };
    for (int i = 0; i < count; ++i) mesh->triangles.push_back({index(), index(), index()});
    return mesh;
  }

  AffineMatrix matrix() {
    AffineMatrix result = identity_matrix();
    switch (style_) {
      case Style::nested:
        for (int depth = integer(1, 8); depth > 0; --depth) result = result * step();
        return result;
      case Style::steep:
        result = rotation() * scaling({1, std::pow(10, uniform(-6, 0)), std::pow(10, uniform(-12, -6))}) * rotation();
        for (auto& row : result) row[3] = uniform(-10, 10);
        return result;
      case Style::singular:
        return singular();
      default:
        for (auto& row : result)
          for (double& entry : row) entry = number();
        return result;
    }
  }

  AffineMatrix rotation() { return rotation_degrees({uniform(-180, 180), uniform(-180, 180), uniform(-180, 180)}); }

  AffineMatrix step() {
    switch (integer(0, 3)) {
      case 0:
        return translation({uniform(-10, 10), uniform(-10, 10), uniform(-10, 10)});
      case 1:
        return rotation();
      case 2:
        return scaling({uniform(-3, 3), uniform(-3, 3), uniform(-3, 3)});
      default: {
        AffineMatrix shear = identity_matrix();
        shear[0][1] = uniform(-2, 2);
        shear[2][0] = uniform(-2, 2);
        return shear;
      }
    }
  }

  AffineMatrix singular() {
    AffineMatrix result{};
    const int kind = integer(0, 3);
    if (kind == 0) return result;
    const Vec3 factors{uniform(-3, 3), uniform(-3, 3), uniform(-3, 3)};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 4; ++j)
        result[i][j] = kind == 1 && j < 3 ? factors[static_cast<int>(i)] * static_cast<double>(j + 1) : uniform(-3, 3);
    const auto gone = static_cast<std::size_t>(integer(0, 2));
    if (kind == 2) result[gone] = {0, 0, 0, result[gone][3]};
    if (kind == 3) result[0][gone] = result[1][gone] = result[2][gone] = 0;
    return result;
  }

  std::mt19937_64 random_;
  Style style_ = Style::nested;
};

}  // namespace plumb

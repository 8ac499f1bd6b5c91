#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "reference/shape.h"
#include "renderer/math/ray.h"

namespace plumb {

/// One ray and one placed triangle that ask for trouble.
struct TriangleCase {
  std::array<Point3, 3> vertices;
  Ray ray;
  AffineMatrix matrix = identity_matrix();

  PlacedShape shape() const {
    PlacedShape placed;
    placed.shape.vertices = vertices;
    placed.world_from_object = matrix;
    return placed;
  }
};

/// Seeded cases by family; the same numbers on every machine but for the last bits of libm, on which nothing depends.
class TriangleCases {
 public:
  static const std::vector<std::string>& families() {
    static const std::vector<std::string> names{
        "control",  "edge", "vertex",  "lattice",    "lattice53", "grazing", "needle",      "tiny",    "far",  "huge",
        "denormal", "zero", "surface", "degenerate", "mirrored",  "sheared", "affine_edge", "extreme", "range"};
    return names;
  }

  explicit TriangleCases(std::uint64_t seed) : random_(seed) {}

  TriangleCase next(const std::string& family) {
    TriangleCase c = random_case(1);
    if (family == "edge") return aim(c, true);
    if (family == "vertex") return aim(c, false);
    if (family == "lattice") return lattice(0, 0);
    if (family == "lattice53") return lattice(std::ldexp(1 + uniform(0, 1), 30), 0x1p-22);
    if (family == "grazing") return grazing();
    if (family == "needle") return needle();
    if (family == "tiny") return aim(random_case(std::exp2(uniform(-60, -10)), 1), coin());
    if (family == "far") return moved(aim(random_case(1), coin()), std::exp2(uniform(10, 24)));
    if (family == "huge") return aim(random_case(std::exp2(uniform(33, 58))), coin());
    if (family == "denormal") return aim(random_case(std::exp2(uniform(-1070, -1000))), coin());
    if (family == "zero") return signed_zeros();
    if (family == "surface") return on_surface();
    if (family == "degenerate") return degenerate();
    if (family == "mirrored") return mapped(true);
    if (family == "sheared") return mapped(false);
    if (family == "affine_edge") return affine_edge();
    if (family == "extreme") return extreme();
    if (family == "range") return in_range();
    return c;
  }

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  bool coin() { return whole(0, 1) == 1; }

 private:
  Point3 point(double size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }

  /// The middle of the triangle, an edge or a vertex, rounded.
  Point3 target(const std::array<Point3, 3>& v, int corners) {
    constexpr Point3 kZero;
    if (corners == 1) return v[0];
    const double s = uniform(0, 1), r = corners == 2 ? 0 : uniform(0, 1 - s);
    return kZero + ((1 - s - r) * (v[0] - kZero) + s * (v[1] - kZero) + r * (v[2] - kZero));
  }

  TriangleCase random_case(double size) { return random_case(size, size); }
  TriangleCase random_case(double size, double distance) {
    TriangleCase c;
    c.vertices = {point(size), point(size), point(size)};
    c.ray.origin = point(3 * distance);
    c.ray.direction = (coin() ? target(c.vertices, 3) : point(2 * size)) - c.ray.origin;
    return c;
  }

  TriangleCase aim(TriangleCase c, bool edge) {
    c.ray.direction = target(c.vertices, edge ? 2 : 1) - c.ray.origin;
    return c;
  }

  TriangleCase lattice(double offset, double step) {
    TriangleCase c;
    for (Point3& p : c.vertices)
      for (int i = 0; i < 3; ++i) p[i] = offset + whole(-4, 4);
    for (int i = 0; i < 3; ++i) c.ray.origin[i] = offset + whole(-9, 9) + step * whole(-1000, 1000);
    Point3 to = c.vertices[0];
    if (coin()) to = c.vertices[1] + 0.5 * (c.vertices[0] - c.vertices[1]);
    c.ray.direction = to - c.ray.origin;
    if (coin()) c.ray.direction = 4.0 * c.ray.direction;
    return c;
  }

  TriangleCase grazing() {
    TriangleCase c = random_case(1);
    const Vec3 n = normalized(plumb::cross(c.vertices[1] - c.vertices[0], c.vertices[2] - c.vertices[0]));
    const Point3 inside = target(c.vertices, 3);
    c.ray.origin = inside + 3.0 * (c.vertices[0] - inside) + std::exp2(uniform(-55, -5)) * n;
    c.ray.direction = target(c.vertices, whole(1, 3)) - c.ray.origin;
    return c;
  }

  TriangleCase needle() {
    TriangleCase c = random_case(1);
    c.vertices[2] = c.vertices[0] + uniform(0, 1) * (c.vertices[1] - c.vertices[0]) +
                    std::exp2(uniform(-60, -10)) * (point(1) - Point3());
    c.ray.direction = target(c.vertices, whole(1, 3)) - c.ray.origin;
    return c;
  }

  TriangleCase moved(TriangleCase c, double distance) {
    const Vec3 offset = distance * (point(1) - Point3());
    for (Point3& p : c.vertices) p = p + offset;
    c.ray.origin = c.ray.origin + offset;
    return aim(c, coin());
  }

  TriangleCase signed_zeros() {
    TriangleCase c = lattice(0, 0);
    for (int i = 0; i < 3; ++i)
      if (whole(0, 2) > 0) c.ray.direction[i] = coin() ? 0.0 : -0.0;
    if (c.ray.direction == Vec3()) c.ray.direction[whole(0, 2)] = -1;
    for (Point3& p : c.vertices)
      for (int i = 0; i < 3; ++i)
        if (p[i] == 0 && coin()) p[i] = -0.0;
    return c;
  }

  TriangleCase on_surface() {
    TriangleCase c = coin() ? lattice(0, 0) : random_case(1);
    c.ray.origin = target(c.vertices, whole(1, 3));
    c.ray.direction = point(1) - Point3();
    if (coin()) c.ray.t_min = -1;
    if (coin()) c.ray.t_max = 0;
    return c;
  }

  TriangleCase degenerate() {
    TriangleCase c = lattice(0, 0);
    const int kind = whole(0, 3);
    if (kind == 0) c.vertices[2] = c.vertices[1];
    if (kind == 1) c.vertices[2] = c.vertices[1] = c.vertices[0];
    if (kind == 2) c.vertices[2] = c.vertices[0] + 2.0 * (c.vertices[1] - c.vertices[0]);
    if (kind == 3) c.ray.direction = c.vertices[0] - c.vertices[1], c.ray.origin = c.vertices[2];
    if (c.ray.direction == Vec3()) c.ray.direction.z = 1;
    return c;
  }

  AffineMatrix random_matrix() {
    AffineMatrix m;
    for (auto& row : m)
      for (double& x : row) x = uniform(-2, 2);
    return m;
  }

  /// Mirrored: a permutation or reflection with dyadic factors. Sheared: 0..1e-9 from singular.
  TriangleCase mapped(bool mirrored) {
    TriangleCase c = lattice(0, 0);
    if (mirrored) {
      c.matrix = scaling({coin() ? 1.0 : -2.0, -1, coin() ? -0.5 : 4.0});
      if (coin()) std::swap(c.matrix[0], c.matrix[1]);
    } else {
      c.matrix = random_matrix();
      const double distance = coin() ? 1e-9 : 0;
      if (coin())
        for (std::size_t j = 0; j < 4; ++j) c.matrix[2][j] = 2 * c.matrix[0][j] + uniform(-1, 1) * distance;
    }
    return c;
  }

  TriangleCase affine_edge() {
    TriangleCase c = random_case(1);
    c.matrix = random_matrix();
    Point3 world;
    const Point3 to = target(c.vertices, whole(1, 2));
    for (int i = 0; i < 3; ++i) {
      const auto& row = c.matrix[static_cast<std::size_t>(i)];
      world[i] = row[0] * to.x + row[1] * to.y + row[2] * to.z + row[3];
    }
    c.ray.direction = world - c.ray.origin;
    return c;
  }

  /// Magnitudes mixed over all exponents that a double has.
  TriangleCase extreme() {
    TriangleCase c = lattice(0, 0);
    const auto stretch = [&](double x) { return std::ldexp(x, whole(0, 3) == 0 ? whole(-1074, 1018) : 0); };
    const double all = whole(-1060, 1010);
    for (Point3& p : c.vertices)
      for (int i = 0; i < 3; ++i) p[i] = coin() ? stretch(p[i]) : std::ldexp(p[i], static_cast<int>(all));
    for (int i = 0; i < 3; ++i) c.ray.direction[i] = stretch(c.ray.direction[i]);
    if (c.ray.direction == Vec3()) c.ray.direction.x = 0x1p-1074;
    if (coin()) c.matrix[1][1] = stretch(1);
    return c;
  }

  /// A range that ends on the crossing, or a double beside it; mostly with t a small fraction.
  TriangleCase in_range() {
    TriangleCase c = lattice(0, 0);
    c.ray.t_max = whole(0, 4) == 0 ? std::numeric_limits<double>::infinity() : whole(-4, 8) * 0.25;
    c.ray.t_min = whole(0, 4) == 0 ? -std::numeric_limits<double>::infinity() : whole(-8, 4) * 0.25;
    if (coin()) c.ray.t_min = std::nextafter(c.ray.t_min, coin() ? 9 : -9);
    if (coin()) c.ray.t_max = std::nextafter(c.ray.t_max, coin() ? 9 : -9);
    if (c.ray.t_min > c.ray.t_max) std::swap(c.ray.t_min, c.ray.t_max);
    return c;
  }

  std::mt19937_64 random_;
};

}  // namespace plumb

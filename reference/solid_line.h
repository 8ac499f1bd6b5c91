#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "reference/shape.h"
#include "renderer/math/ray.h"

namespace plumb {

template <class N>
using Three = std::array<N, 3>;

/// The linear part of a placement without a division: inverse = adjugate / det.
template <class N>
struct SolidFrame {
  std::array<Three<N>, 3> adjugate;
  N det;
};

/// The cyclic indices give each cofactor its sign.
template <class N>
SolidFrame<N> solid_frame(const AffineMatrix& m) {
  const auto e = [&](std::size_t r, std::size_t c) { return N(m[r % 3][c % 3]); };
  SolidFrame<N> frame;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c)
      frame.adjugate[c][r] = e(r + 1, c + 1) * e(r + 2, c + 2) - e(r + 1, c + 2) * e(r + 2, c + 1);
  frame.det = e(0, 0) * frame.adjugate[0][0] + e(0, 1) * frame.adjugate[1][0] + e(0, 2) * frame.adjugate[2][0];
  return frame;
}

template <class N>
void multiply(SolidFrame<N>& frame, const N& factor) {
  for (auto& row : frame.adjugate)
    for (auto& entry : row) entry = entry * factor;
  frame.det = frame.det * factor;
}

/// A ray's line against the limits of a solid, in its frame times `det`: x = from + t along, about the sphere's or the
/// cylinder's centre, the cone's tip, or the origin of a box. The solid is where
///   a t^2 + 2 b t + c = sum w_i x_i^2 - (det radius)^2 <= 0, unless it has no side, and
///   at + t slope >= 0 for each plane; planes 2 i and 2 i + 1 are a slab.
/// N is any ring that doubles map into.
template <class N>
struct SolidLine {
  struct Plane {
    N at, slope;
    std::uint32_t part = 0;
    int axis = 0;
  };
  SolidFrame<N> frame;
  Three<N> from, along;
  bool has_side = false;
  Three<N> weight;
  N a, b, c, discriminant;
  std::array<Plane, 6> planes;
  std::size_t plane_count = 0;
};

template <class N>
void add_plane(SolidLine<N>& line, const N& at, const N& slope, std::uint32_t part, int axis) {
  line.planes[line.plane_count++] = {at, slope, part, axis};
}

/// The discriminant b^2 - a c by Lagrange's identity, as products of 2x2 minors: the squares of far origins would
/// cancel.
template <class N>
void add_side(SolidLine<N>& line, const N& radius) {
  const Three<N>& w = line.weight;
  const Three<N>& f = line.from;
  const Three<N>& d = line.along;
  const N square = radius * radius;
  line.has_side = true;
  line.a = w[0] * d[0] * d[0] + w[1] * d[1] * d[1] + w[2] * d[2] * d[2];
  line.b = w[0] * f[0] * d[0] + w[1] * f[1] * d[1] + w[2] * f[2] * d[2];
  line.c = w[0] * f[0] * f[0] + w[1] * f[1] * f[1] + w[2] * f[2] * f[2] - square;
  line.discriminant = line.a * square;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const N minor = f[i] * d[j] - f[j] * d[i];
    line.discriminant = line.discriminant - w[i] * w[j] * (minor * minor);
  }
}

/// |z - center| <= height / 2, where z = origin + x; both doubled.
template <class N>
void add_caps(SolidLine<N>& line, const N& center_from_origin, double height) {
  const N& det = line.frame.det;
  const N middle = N(2) * (line.from[2] - det * center_from_origin);
  const N slope = N(2) * line.along[2];
  add_plane(line, det * N(height) + middle, slope, 1, 2);
  add_plane(line, det * N(height) - middle, -slope, 2, 2);
}

template <class N>
void add_box(SolidLine<N>& line, const Shape& shape) {
  for (std::size_t i = 0; i < 3; ++i) {
    const int axis = static_cast<int>(i);
    const auto part = static_cast<std::uint32_t>(2 * i);
    const N& det = line.frame.det;
    add_plane(line, line.from[i] - det * N(shape.min[axis]), line.along[i], part, axis);
    add_plane(line, det * N(shape.max[axis]) - line.from[i], -line.along[i], part + 1, axis);
  }
}

/// Needs det > 0 in `frame`.
template <class N>
SolidLine<N> solid_line(const PlacedShape& placed, const SolidFrame<N>& frame, const Ray& ray) {
  const Shape& shape = placed.shape;
  SolidLine<N> line;
  line.frame = frame;
  Three<N> origin, direction;
  for (std::size_t j = 0; j < 3; ++j) {
    origin[j] = N(ray.origin[static_cast<int>(j)]) - N(placed.world_from_object[j][3]);
    direction[j] = N(ray.direction[static_cast<int>(j)]);
  }
  Point3 about = shape.kind == ShapeKind::box ? Point3{} : shape.center;
  if (shape.kind == ShapeKind::cone) about.z = shape.tip_z;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& row = frame.adjugate[i];
    line.from[i] =
        row[0] * origin[0] + row[1] * origin[1] + row[2] * origin[2] - frame.det * N(about[static_cast<int>(i)]);
    line.along[i] = row[0] * direction[0] + row[1] * direction[1] + row[2] * direction[2];
  }
  const N radius(shape.radius);
  switch (shape.kind) {
    case ShapeKind::sphere:
      line.weight = {N(1), N(1), N(1)};
      add_side(line, N(frame.det * radius));
      break;
    case ShapeKind::cylinder:
      line.weight = {N(1), N(1), N(0)};
      add_side(line, N(frame.det * radius));
      add_caps(line, N(0), shape.height);
      break;
    case ShapeKind::cone: {
      const N length = N(shape.center.z) - N(shape.tip_z);
      line.weight = {length * length, length * length, -(radius * radius)};
      add_side(line, N(0));
      add_caps(line, length, shape.height);
      break;
    }
    default:
      add_box(line, shape);
  }
  return line;
}

}  // namespace plumb

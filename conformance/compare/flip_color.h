#pragma once

#include <array>

#include "conformance/compare/float_lanes.h"

namespace plumb {

/// Rows of a 3 x 3 matrix.
using FlipMatrix = std::array<std::array<float, 3>, 3>;

/// Linear sRGB to XYZ, each divided by that of white [IEC 61966-2-1].
constexpr FlipMatrix kRelativeXyzFromRgb = [] {
  constexpr std::array<std::array<double, 3>, 3> xyz{
      {{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}};
  FlipMatrix result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      result[i][j] = static_cast<float>(xyz[i][j] / (xyz[i][0] + xyz[i][1] + xyz[i][2]));
  return result;
}();

/// Its inverse, by Cramer's rule.
constexpr FlipMatrix kRgbFromRelativeXyz = [] {
  const FlipMatrix& m = kRelativeXyzFromRgb;
  const auto minor = [&](std::size_t i, std::size_t j) {
    const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
    return static_cast<double>(m[a][c]) * m[b][d] - static_cast<double>(m[a][d]) * m[b][c];
  };
  const double determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  FlipMatrix result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = static_cast<float>(minor(j, i) / determinant);
  return result;
}();

inline std::array<Lanes, 3> times(const FlipMatrix& m, Lanes x, Lanes y, Lanes z) {
  return {m[0][0] * x + m[0][1] * y + m[0][2] * z, m[1][0] * x + m[1][1] * y + m[1][2] * z,
          m[2][0] * x + m[2][1] * y + m[2][2] * z};
}

/// CIELAB, its chroma weighed by lightness after Hunt: colours that are dark look less colourful.
struct HuntLab {
  Lanes lightness, a, b;
};

/// Of XYZ relative to white, each from 0 to 1.
inline HuntLab hunt_lab(const std::array<Lanes, 3>& xyz) {
  const auto compressed = [](Lanes t) {
    constexpr float kKnee = 6.0F / 29;
    const Lanes root = cube_root_of(higher_of(t, all_lanes(1e-6F)));
    return t > kKnee * kKnee * kKnee ? root : t * (1 / (3 * kKnee * kKnee)) + 4.0F / 29;
  };
  const Lanes x = compressed(xyz[0]), y = compressed(xyz[1]), z = compressed(xyz[2]);
  const Lanes lightness = 116.0F * y - 16.0F, hunt = 0.01F * lightness;
  return {lightness, hunt * 500.0F * (x - y), hunt * 200.0F * (y - z)};
}

}  // namespace plumb

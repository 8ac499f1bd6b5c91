#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "renderer/math/vec3.h"

namespace plumb {

/// A texture coordinate; not clamped to [0, 1].
struct TexCoord {
  double u = 0, v = 0;
  friend constexpr bool operator==(const TexCoord&, const TexCoord&) = default;
};

/// An indexed triangle mesh in object space. A triangle is three indices into `positions`,
/// counter-clockwise seen from its front. Nothing is promised about shape: triangles may be degenerate,
/// edges may have any number of triangles, vertices may be unused or equal, and both lists may be empty.
struct TriangleMesh {
  std::vector<Point3> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// Empty, or one a vertex; not assumed to have unit length.
  std::vector<Normal3> normals;
  /// Empty, or one a vertex.
  std::vector<TexCoord> texcoords;
  friend bool operator==(const TriangleMesh&, const TriangleMesh&) = default;
};

}  // namespace plumb

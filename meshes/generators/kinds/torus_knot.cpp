#include "meshes/generators/asked_size.h"
#include "meshes/generators/correctly_rounded.h"
#include "meshes/generators/mesh_kind.h"
#include "meshes/generators/progress_steps.h"

namespace plumb {
namespace {

/// The torus that carries the knot, and the tube around the knot. By measurement strands come no closer to one another
/// than 0.89 and no bend is tighter than 0.73, so tubes up to 0.44 do not meet themselves.
constexpr double kLarge = 1, kSmall = 0.45, kTube = 0.16;

/// A point of the knot, with the torus's normal there and a third direction at right angles to both knot and normal.
/// The torus's normal turns back into itself along the knot, so the tube closes without a twist.
struct Frame {
  Point3 at;
  Vec3 normal, side;
};

/// `twice` and `thrice` are two and three times the angle along the knot: twice around the axis, three times through
/// the hole.
Frame knot(const SinCos& twice, const SinCos& thrice) {
  const double out = kLarge + kSmall * thrice.cos;
  const Vec3 normal{thrice.cos * twice.cos, thrice.cos * twice.sin, thrice.sin};
  const Vec3 along{-3 * kSmall * thrice.sin * twice.cos - 2 * out * twice.sin,
                   -3 * kSmall * thrice.sin * twice.sin + 2 * out * twice.cos, 3 * kSmall * thrice.cos};
  return {{out * twice.cos, out * twice.sin, kSmall * thrice.sin}, normal, normalized(cross(along, normal))};
}

TriangleMesh make(const MeshRequest& request) {
  // The knot is about 16 times as long as the tube is around: nearly square quadrilaterals.
  const std::uint32_t around = least_size(asked_triangles(request), 3, [](std::uint64_t n) { return 2 * n * 16 * n; });
  const std::uint32_t along = 16 * around;
  const std::vector<SinCos> turn = parts_of_a_turn(along);

  TriangleMesh mesh;
  const std::size_t vertices = std::size_t{along} * around;
  mesh.positions.reserve(vertices);
  mesh.normals.reserve(vertices);
  mesh.triangles.reserve(2 * vertices);
  ProgressSteps steps(request.progress, along);
  const auto vertex = [&](std::uint32_t i, std::uint32_t j) { return i % along * around + j % around; };
  for (std::uint32_t i = 0; i < along; ++i) {
    const Frame frame = knot(turn[2 * i % along], turn[3 * i % along]);
    for (std::uint32_t j = 0; j < around; ++j) {
      const SinCos& angle = turn[16 * j];
      const Vec3 out = normalized(angle.cos * frame.normal + angle.sin * frame.side);
      mesh.positions.push_back(frame.at + kTube * out);
      mesh.normals.push_back(as_normal(out));
      const std::uint32_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
      mesh.triangles.insert(mesh.triangles.end(), {{a, c, b}, {a, d, c}});
    }
    steps.step();
  }
  return mesh;
}

}  // namespace

extern const MeshKind torus_knot_kind{
    "torus_knot", "A tube along the trefoil, twice around a torus and three times through its hole.", true, false,
    make};

}  // namespace plumb

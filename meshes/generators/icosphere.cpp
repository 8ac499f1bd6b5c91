#include "meshes/generators/icosphere.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "meshes/generators/progress_steps.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// The point of the unit sphere in the direction of `v`.
Point3 on_sphere(const Vec3& v) {
  const Vec3 unit = normalized(v);
  return {unit.x, unit.y, unit.z};
}

Vec3 from_origin(const Point3& p) { return p - Point3{}; }

/// Three golden rectangles through the origin, one in each coordinate plane, span the icosahedron.
TriangleMesh icosahedron() {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  TriangleMesh mesh;
  for (int plane = 0; plane < 3; ++plane) {
    for (const double y : {-1.0, 1.0}) {
      for (const double z : {-golden, golden}) {
        Vec3 corner;
        corner[(plane + 1) % 3] = y;
        corner[(plane + 2) % 3] = z;
        mesh.positions.push_back(on_sphere(corner));
      }
    }
  }
  // The faces are the triples of neighbours; neighbours are 1.05 apart, the next distance is 1.70.
  const auto near = [&](std::uint32_t a, std::uint32_t b) {
    return length(mesh.positions[a] - mesh.positions[b]) < 1.4;
  };
  for (std::uint32_t a = 0; a < 12; ++a) {
    for (std::uint32_t b = a + 1; b < 12; ++b) {
      for (std::uint32_t c = b + 1; c < 12; ++c) {
        if (!near(a, b) || !near(b, c) || !near(c, a)) continue;
        const Vec3 pa = from_origin(mesh.positions[a]);
        const bool outward = dot(pa, cross(from_origin(mesh.positions[b]), from_origin(mesh.positions[c]))) > 0;
        mesh.triangles.push_back(outward ? Triangle{a, b, c} : Triangle{a, c, b});
      }
    }
  }
  return mesh;
}

/// Numbers the midpoints of edges, each edge once whichever of its faces asks first.
class Midpoints {
 public:
  Midpoints(std::vector<Point3>& positions, std::size_t edges) : positions_(positions), of_lower_(positions.size()) {
    positions.reserve(positions.size() + edges);
  }

  std::uint32_t between(std::uint32_t a, std::uint32_t b) {
    // At most six edges meet in a vertex of an icosphere: a short list at the lower end of each edge.
    for (Edge& edge : of_lower_[std::min(a, b)]) {
      if (edge.upper == std::max(a, b)) return edge.middle;
      if (edge.upper != kNone) continue;
      edge = {std::max(a, b), static_cast<std::uint32_t>(positions_.size())};
      positions_.push_back(on_sphere(from_origin(positions_[a]) + from_origin(positions_[b])));
      return edge.middle;
    }
    throw std::logic_error("icosphere: seven edges meet in a vertex");
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;
  struct Edge {
    std::uint32_t upper = kNone, middle = kNone;
  };
  std::vector<Point3>& positions_;
  std::vector<std::array<Edge, 6>> of_lower_;
};

}  // namespace

TriangleMesh icosphere(int subdivisions, const std::function<void(double)>& progress) {
  if (subdivisions < 0 || subdivisions > 10) {
    throw std::invalid_argument("icosphere: " + std::to_string(subdivisions) + " subdivisions; expected 0 to 10");
  }
  TriangleMesh mesh = icosahedron();
  // 20 + 80 + ... faces are cut in all, and the normals are one step more.
  ProgressSteps steps(progress, 20 * ((std::uint64_t{1} << (2 * subdivisions)) - 1) / 3 + 1);
  for (int level = 0; level < subdivisions; ++level) {
    Midpoints midpoints(mesh.positions, mesh.triangles.size() * 3 / 2);
    std::vector<Triangle> finer;
    finer.reserve(4 * mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::uint32_t ab = midpoints.between(a, b);
      const std::uint32_t bc = midpoints.between(b, c);
      const std::uint32_t ca = midpoints.between(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
      steps.step();
    }
    mesh.triangles = std::move(finer);
  }
  mesh.normals.reserve(mesh.positions.size());
  for (const Point3& p : mesh.positions) mesh.normals.push_back({p.x, p.y, p.z});
  steps.step();
  return mesh;
}

int icosphere_subdivisions(std::uint64_t triangles) {
  std::uint64_t has = 20;
  int subdivisions = 0;
  for (; has < triangles && subdivisions < 11; ++subdivisions) has *= 4;
  if (subdivisions > 10) throw InputError({}, "an icosphere has at most 20971520 triangles, expected no more");
  return subdivisions;
}

}  // namespace plumb

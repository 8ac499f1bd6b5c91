// A kernel that is right for triangles of ordinary size, and fails for coordinates past a million as
// PLUMB_OVERFLOWING_KERNEL in the environment says: crash, hang or nan. Built without sanitizers and without our
// libraries, as a stranger's would be.
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "conformance/kernel/plumb_kernel.h"

namespace {

struct Triple {
  double x, y, z;
};
Triple operator-(const Triple& a, const Triple& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(const Triple& a, const Triple& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Triple cross(const Triple& a, const Triple& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct Triangle {
  std::uint32_t surface, index;
  Triple a, b, c;
};
using Scene = std::vector<Triangle>;

/// The cell of a grid, whose whole numbers overflow: where the failures come from.
double cell_of(double coordinate) {
  constexpr double kMost = 1e6;
  const char* variable = std::getenv("PLUMB_OVERFLOWING_KERNEL");
  const std::string_view way = variable ? variable : "";
  if (!(std::fabs(coordinate) > kMost)) return 0;
  if (way == "crash") std::raise(SIGSEGV);
  if (way == "hang")
    for (;;) ::usleep(1000);
  return way == "nan" ? std::nan("") : 0;
}

void intersect(const Triangle& triangle, const plumb_rays* rays, plumb_hits* hits, std::size_t i) {
  const Triple o{rays->ox[i], rays->oy[i], rays->oz[i]}, d{rays->dx[i], rays->dy[i], rays->dz[i]};
  const Triple e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a, s = o - triangle.a;
  const Triple p = cross(d, e2), q = cross(s, e1);
  const double determinant = dot(e1, p);
  const double u = dot(s, p) / determinant, v = dot(d, q) / determinant, t = dot(e2, q) / determinant;
  if (determinant == 0 || !(u >= 0 && v >= 0 && u + v <= 1 && t >= rays->t_min[i] && t <= rays->t_max[i])) return;
  if (hits->surface[i] != PLUMB_MISS && hits->t[i] <= t) return;
  hits->surface[i] = triangle.surface;
  hits->primitive[i] = triangle.index;
  hits->t[i] = t + cell_of(triangle.a.x);
  hits->u[i] = u;
  hits->v[i] = v;
}

plumb_scene* build(const plumb_surface* surfaces, std::size_t count, char*, std::size_t) {
  auto* scene = new Scene;
  for (std::uint32_t k = 0; k < count; ++k) {
    const plumb_mesh& mesh = surfaces[k].mesh;
    for (std::uint32_t i = 0; i < mesh.triangle_count; ++i) {
      const auto corner = [&](std::size_t place) {
        const double* at = mesh.positions + 3 * static_cast<std::size_t>(mesh.triangles[3 * i + place]);
        return Triple{at[0], at[1], at[2]};
      };
      scene->push_back({k, i, corner(0), corner(1), corner(2)});
    }
  }
  return reinterpret_cast<plumb_scene*>(scene);
}

void destroy(plumb_scene* scene) { delete reinterpret_cast<Scene*>(scene); }

void closest_hit(const plumb_scene* scene, const plumb_rays* rays, plumb_hits* hits) {
  for (std::size_t i = 0; i < rays->count; ++i) {
    hits->surface[i] = PLUMB_MISS;
    for (const Triangle& triangle : *reinterpret_cast<const Scene*>(scene)) intersect(triangle, rays, hits, i);
  }
}

}  // namespace

extern "C" const plumb_kernel* plumb_kernel_v1(void) {
  static const plumb_kernel table{PLUMB_KERNEL_VERSION,
                                  sizeof(plumb_kernel),
                                  "overflowing",
                                  "a kernel for tests",
                                  {PLUMB_DOUBLE, PLUMB_DOUBLE, PLUMB_CULL_NONE, PLUMB_EDGE_NONE, PLUMB_RANGE_CLOSED,
                                   PLUMB_INSIDE_HITS_EXIT, PLUMB_MESHES, 0, 0},
                                  build,
                                  destroy,
                                  closest_hit,
                                  nullptr,
                                  nullptr,
                                  nullptr};
  return &table;
}

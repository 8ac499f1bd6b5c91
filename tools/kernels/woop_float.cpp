#include <utility>

#include "tools/kernels/triangle.h"

namespace plumb::kernels {
namespace {

/// A ray with the shear and scale that take its direction to the unit vector of its longest axis.
struct ShearedRealRay : RealRay<float> {
  explicit ShearedRealRay(const Ray& of) : RealRay(of) {
    const float x = std::fabs(direction.x), y = std::fabs(direction.y), z = std::fabs(direction.z);
    kz = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
    kx = (kz + 1) % 3;
    ky = (kx + 1) % 3;
    if (direction[kz] < 0) std::swap(kx, ky);  // keeps the winding
    shear_x = direction[kx] / direction[kz];
    shear_y = direction[ky] / direction[kz];
    scale_z = 1 / direction[kz];
  }

  int kx, ky, kz;
  float shear_x, shear_y, scale_z;
};

/// The watertight test of [Woop 2013] in single precision: seen along the ray, each vertex is one rounded point for all
/// triangles that share it. Where an edge function is zero, all three are taken again in doubles, which hold the
/// products of floats exactly.
struct Watertight : Triangle<Watertight, float> {
  using PreparedRay = ShearedRealRay;

  template <class Report>
  void intersect(const PreparedRay& ray, Report&& report) const {
    const Triple<float> a = seen_along(ray, corners[0]);
    const Triple<float> b = seen_along(ray, corners[1]);
    const Triple<float> c = seen_along(ray, corners[2]);
    float of_a = c.x * b.y - c.y * b.x;
    float of_b = a.x * c.y - a.y * c.x;
    float of_c = b.x * a.y - b.y * a.x;
    if (of_a == 0 || of_b == 0 || of_c == 0) {
      of_a = in_doubles(c, b);
      of_b = in_doubles(a, c);
      of_c = in_doubles(b, a);
    }
    if ((of_a < 0 || of_b < 0 || of_c < 0) && (of_a > 0 || of_b > 0 || of_c > 0)) return;
    const float sum = of_a + of_b + of_c;
    if (sum == 0) return;
    const float inverse = 1 / sum;
    const float t = (of_a * a.z + of_b * b.z + of_c * c.z) * inverse;
    const float u = of_b * inverse, v = of_c * inverse;
    if (ray.contains(t) && std::isfinite(u) && std::isfinite(v)) report(t, u, v);
  }

 private:
  static Triple<float> seen_along(const PreparedRay& ray, const Triple<float>& corner) {
    const Triple<float> p = corner - ray.origin;
    return {p[ray.kx] - ray.shear_x * p[ray.kz], p[ray.ky] - ray.shear_y * p[ray.kz], ray.scale_z * p[ray.kz]};
  }
  static float in_doubles(const Triple<float>& p, const Triple<float>& q) {
    return static_cast<float>(static_cast<double>(p.x) * q.y - static_cast<double>(p.y) * q.x);
  }
};

constexpr plumb_contract kContract{.precision = PLUMB_FLOAT,
                                   .t_precision = PLUMB_FLOAT,
                                   .culling = PLUMB_CULL_NONE,
                                   .edge_rule = PLUMB_EDGE_WATERTIGHT,
                                   .range = PLUMB_RANGE_CLOSED,
                                   .inside = PLUMB_INSIDE_HITS_EXIT,
                                   .shapes = PLUMB_MESHES,
                                   .capabilities = PLUMB_THREAD_SAFE,
                                   .largest = 0};

}  // namespace
}  // namespace plumb::kernels

PLUMB_KERNEL_EXPORT const plumb_kernel* plumb_kernel_v1() {
  using namespace plumb::kernels;
  static const plumb_kernel table = KernelTable<PrimitiveKernel<Watertight>>::make(
      "woop-float",
      "watertight test of Woop, Benthin, Wald 2013 in single precision, scalar, in a binary hierarchy of doubles",
      kContract);
  return &table;
}

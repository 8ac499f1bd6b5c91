#pragma once

#include <algorithm>
#include <cstdint>
#include <exception>
#include <span>
#include <string_view>
#include <vector>

#include "conformance/kernel/plumb_kernel.h"
#include "renderer/math/bounds3.h"
#include "renderer/math/ray.h"

namespace plumb::kernels {

/// One answer. It is a miss until it is said otherwise.
struct Hit {
  std::uint32_t surface = PLUMB_MISS;
  std::uint32_t primitive = 0;
  double t = 0, u = 0, v = 0;
  bool found() const { return surface != PLUMB_MISS; }
};

/// The order in which a hit is the closest: by t, then the surface and the primitive that come first.
inline bool comes_before(const Hit& a, const Hit& b) {
  if (a.found() != b.found()) return a.found();
  if (a.t != b.t) return a.t < b.t;
  return a.surface != b.surface ? a.surface < b.surface : a.primitive < b.primitive;
}

/// Makes the C functions of a class
///
///     class Kernel {
///      public:
///       explicit Kernel(std::span<const plumb_surface>);  // may throw: the scene is refused, with what() as the
///       reason Hit closest(const Ray&) const; bool any(const Ray&) const;                        // these three only
///       if it can void all(const Ray&, std::vector<Hit>&) const;     // appends std::vector<Bounds3> bounds() const;
///     };
///
/// The bits of the capabilities of these functions are set by their presence.
template <class Kernel>
class KernelTable {
 public:
  static plumb_kernel make(const char* name, const char* description, plumb_contract contract) {
    plumb_kernel table{PLUMB_KERNEL_VERSION,
                       sizeof(plumb_kernel),
                       name,
                       description,
                       contract,
                       build,
                       destroy,
                       closest_hit,
                       nullptr,
                       nullptr,
                       nullptr};
    if constexpr (requires(const Kernel& k, const Ray& ray) { k.any(ray); }) {
      table.any_hit = any_hit;
      table.contract.capabilities |= PLUMB_ANY_HIT;
    }
    if constexpr (requires(const Kernel& k, const Ray& ray, std::vector<Hit>& hits) { k.all(ray, hits); }) {
      table.all_hits = all_hits;
      table.contract.capabilities |= PLUMB_ALL_HITS;
    }
    if constexpr (requires(const Kernel& k) { k.bounds(); }) {
      table.bounds = bounds;
      table.contract.capabilities |= PLUMB_BOUNDS;
    }
    return table;
  }

 private:
  static plumb_scene* build(const plumb_surface* surfaces, size_t count, char* error, size_t error_size) {
    try {
      return reinterpret_cast<plumb_scene*>(new Kernel(std::span(surfaces, count)));
    } catch (const std::exception& refusal) {
      if (error_size == 0) return nullptr;
      const std::string_view text = refusal.what();
      error[text.copy(error, error_size - 1)] = '\0';
      return nullptr;
    }
  }
  static void destroy(plumb_scene* scene) { delete reinterpret_cast<Kernel*>(scene); }
  static const Kernel& kernel(const plumb_scene* scene) { return *reinterpret_cast<const Kernel*>(scene); }

  static Ray ray(const plumb_rays& rays, size_t i) {
    return {{rays.ox[i], rays.oy[i], rays.oz[i]}, {rays.dx[i], rays.dy[i], rays.dz[i]}, rays.t_min[i], rays.t_max[i]};
  }
  static void write(const Hit& hit, plumb_hits& hits, size_t i) {
    hits.surface[i] = hit.surface;
    if (!hit.found()) return;
    hits.primitive[i] = hit.primitive;
    hits.t[i] = hit.t;
    hits.u[i] = hit.u;
    hits.v[i] = hit.v;
  }

  static void closest_hit(const plumb_scene* scene, const plumb_rays* rays, plumb_hits* hits) {
    for (size_t i = 0; i < rays->count; ++i) write(kernel(scene).closest(ray(*rays, i)), *hits, i);
  }
  static void any_hit(const plumb_scene* scene, const plumb_rays* rays, uint8_t* hit) {
    for (size_t i = 0; i < rays->count; ++i) hit[i] = kernel(scene).any(ray(*rays, i));
  }
  static void all_hits(const plumb_scene* scene, const plumb_rays* rays, size_t capacity, plumb_hits* hits,
                       uint32_t* count) {
    std::vector<Hit> found;
    for (size_t i = 0; i < rays->count; ++i) {
      found.clear();
      kernel(scene).all(ray(*rays, i), found);
      count[i] = static_cast<uint32_t>(found.size());
      for (size_t k = 0; k < std::min(found.size(), capacity); ++k) write(found[k], *hits, i * capacity + k);
    }
  }
  static void bounds(const plumb_scene* scene, double* six_a_surface) {
    for (const Bounds3& box : kernel(scene).bounds()) {
      for (int axis = 0; axis < 3; ++axis) *six_a_surface++ = box.min[axis];
      for (int axis = 0; axis < 3; ++axis) *six_a_surface++ = box.max[axis];
    }
  }
};

}  // namespace plumb::kernels

/// In front of the definition of the one function that a kernel exports: all else is hidden.
#define PLUMB_KERNEL_EXPORT extern "C" __attribute__((visibility("default")))

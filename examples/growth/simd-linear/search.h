// Asks everything, four triangles at a time in single precision; what may be a hit is asked again in double.
#pragma once

#include <xmmintrin.h>

#include <utility>
#include <vector>

#include "primitives.h"

using Four = float __attribute__((vector_size(16)));

struct Search {
  static constexpr int kThreads = 1;
  struct Block {  // of four triangles
    Four ax{}, ay{}, az{}, e1x{}, e1y{}, e1z{}, e2x{}, e2y{}, e2z{}, nx{}, ny{}, nz{};
    int first = 0;
  };
  std::vector<Primitive> triangles, spheres;
  std::vector<Block> blocks;

  void build(std::vector<Primitive> list) {
    for (const Primitive& p : list) (p.radius < 0 ? triangles : spheres).push_back(p);
    for (size_t i = 0; i < triangles.size(); ++i) {
      if (i % 4 == 0) blocks.emplace_back(), blocks.back().first = static_cast<int>(i);
      Block& b = blocks.back();
      const Primitive& p = triangles[i];
      const Vec n = cross(p.edge1, p.edge2);
      auto set = [i](Four& x, Four& y, Four& z, Vec v) {
        x[i % 4] = static_cast<float>(v.x), y[i % 4] = static_cast<float>(v.y), z[i % 4] = static_cast<float>(v.z);
      };
      set(b.ax, b.ay, b.az, p.a), set(b.nx, b.ny, b.nz, n);
      set(b.e1x, b.e1y, b.e1z, p.edge1), set(b.e2x, b.e2y, b.e2z, p.edge2);
    }
  }

  bool closest(const Ray& ray, Hit& hit) const {
    const auto px = static_cast<float>(ray.origin.x), py = static_cast<float>(ray.origin.y);
    const auto pz = static_cast<float>(ray.origin.z), dx = static_cast<float>(ray.direction.x);
    const auto dy = static_cast<float>(ray.direction.y), dz = static_cast<float>(ray.direction.z);
    constexpr float kSlack = 1e-3f;  // well above the rounding errors
    auto end = static_cast<float>(hit.t) * (1 + kSlack);
    for (const Block& b : blocks) {
      const Four ox = px - b.ax, oy = py - b.ay, oz = pz - b.az;
      const Four rx = oy * dz - oz * dy, ry = oz * dx - ox * dz, rz = ox * dy - oy * dx;
      const Four f = -1 / (dx * b.nx + dy * b.ny + dz * b.nz);
      const Four t = (ox * b.nx + oy * b.ny + oz * b.nz) * f;
      const Four beta = (rx * b.e2x + ry * b.e2y + rz * b.e2z) * f;
      const Four gamma = -(rx * b.e1x + ry * b.e1y + rz * b.e1z) * f;
      const auto may =
          (beta >= -kSlack) & (gamma >= -kSlack) & (beta + gamma <= 1 + 2 * kSlack) & (t >= -kSlack) & (t <= end);
      int lanes = _mm_movemask_ps(reinterpret_cast<__m128>(may));
      for (int i = b.first; lanes != 0; ++i, lanes >>= 1)
        if (lanes & 1) triangles[i].intersect(ray, hit), end = static_cast<float>(hit.t) * (1 + kSlack);
    }
    for (const Primitive& p : spheres) p.intersect(ray, hit);
    return hit.primitive != nullptr;
  }
};

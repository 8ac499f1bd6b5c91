// A uniform grid over the scene's box, with about two cells a primitive, walked from cell to cell.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "primitives.h"

struct Search {
  static constexpr int kThreads = 1;
  std::vector<Primitive> primitives;
  Box box;
  Vec cell;                     // its size
  int count[3];                 // of cells along each axis
  std::vector<int> starts, in;  // in[starts[c]] to in[starts[c + 1]] are the primitives of cell c

  void build(std::vector<Primitive> list) {
    primitives = std::move(list);
    if (primitives.empty()) return;
    for (const Primitive& p : primitives) box.add(p.box());
    const double longest = std::max({box.size().x, box.size().y, box.size().z});
    const Vec pad = Vec{1, 1, 1} * (1e-6 * longest);
    box.low = box.low - pad, box.high = box.high + pad;
    const Vec size = box.size();
    const double edge = std::cbrt(size.x * size.y * size.z / (2.0 * static_cast<double>(primitives.size())));
    for (int k = 0; k < 3; ++k)
      count[k] = static_cast<int>(std::min(2000.0, std::max(1.0, std::round(size[k] / edge))));
    cell = {size.x / count[0], size.y / count[1], size.z / count[2]};

    starts.assign(static_cast<size_t>(count[0]) * count[1] * count[2] + 1, 0);
    for_each_cell([&](int c, int) { ++starts[c + 1]; });
    for (size_t c = 1; c < starts.size(); ++c) starts[c] += starts[c - 1];
    in.resize(starts.back());
    std::vector<int> next = starts;
    for_each_cell([&](int c, int p) { in[next[c]++] = p; });
  }

  bool closest(const Ray& ray, Hit& hit) const {
    double t = primitives.empty() ? INFINITY : box.entry(ray, hit.t);
    if (t == INFINITY) return false;
    int at[3], step[3];
    double leave[3];  // where the ray leaves the cell along each axis
    for (int k = 0; k < 3; ++k) {
      at[k] = index(ray.origin[k] + t * ray.direction[k], k);
      step[k] = ray.direction[k] > 0 ? 1 : -1;
      leave[k] = border(ray, k, at[k] + (step[k] > 0));
    }
    for (;;) {
      const int c = (at[2] * count[1] + at[1]) * count[0] + at[0];
      for (int i = starts[c]; i < starts[c + 1]; ++i) primitives[in[i]].intersect(ray, hit);
      const int k = leave[0] < leave[1] ? (leave[0] < leave[2] ? 0 : 2) : (leave[1] < leave[2] ? 1 : 2);
      at[k] += step[k];
      if (hit.t <= leave[k] || at[k] < 0 || at[k] >= count[k]) return hit.primitive != nullptr;
      leave[k] = border(ray, k, at[k] + (step[k] > 0));
    }
  }

 private:
  int index(double x, int k) const {
    return std::min(count[k] - 1, std::max(0, static_cast<int>((x - box.low[k]) / cell[k])));
  }
  double border(const Ray& ray, int k, int i) const {
    if (ray.direction[k] == 0) return INFINITY;
    return (box.low[k] + i * cell[k] - ray.origin[k]) * ray.inverse[k];
  }
  // Calls visit(cell, primitive) for all cells that a primitive's box meets, with a margin for rounding.
  template <class Visit>
  void for_each_cell(Visit visit) const {
    for (size_t p = 0; p < primitives.size(); ++p) {
      const Box b = primitives[p].box();
      const Vec low = b.low - cell * 1e-6, high = b.high + cell * 1e-6;
      for (int z = index(low.z, 2); z <= index(high.z, 2); ++z)
        for (int y = index(low.y, 1); y <= index(high.y, 1); ++y)
          for (int x = index(low.x, 0); x <= index(high.x, 0); ++x)
            visit((z * count[1] + y) * count[0] + x, static_cast<int>(p));
    }
  }
};

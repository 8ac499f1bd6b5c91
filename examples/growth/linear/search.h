// Asks everything.
#pragma once

#include <utility>
#include <vector>

#include "primitives.h"

struct Search {
  static constexpr int kThreads = 1;
  std::vector<Primitive> primitives;

  void build(std::vector<Primitive> list) { primitives = std::move(list); }
  bool closest(const Ray& ray, Hit& hit) const {
    for (const Primitive& p : primitives) p.intersect(ray, hit);
    return hit.primitive != nullptr;
  }
};

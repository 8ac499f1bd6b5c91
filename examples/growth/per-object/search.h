// A hierarchy for each surface of the scene, and a list of them: fine for one big mesh, linear in many small surfaces.
#pragma once

#include <utility>
#include <vector>

#include "hierarchy.h"

struct Search {
  static constexpr int kThreads = 1;
  std::vector<Hierarchy> surfaces;

  void build(const std::vector<Primitive>& list) {
    for (auto first = list.begin(), last = first; first != list.end(); first = last) {
      while (last != list.end() && last->object == first->object) ++last;
      surfaces.emplace_back();
      surfaces.back().build({first, last}, median_split);
    }
  }
  bool closest(const Ray& ray, Hit& hit) const {
    for (const Hierarchy& surface : surfaces) surface.closest(ray, hit);
    return hit.primitive != nullptr;
  }
};

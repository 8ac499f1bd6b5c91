// A hierarchy that visits every box along the whole ray: the left child first, whichever is nearer, and whatever has
// been hit already.
#pragma once

#include <utility>
#include <vector>

#include "hierarchy.h"

struct Search : Hierarchy {
  static constexpr int kThreads = 1;
  void build(std::vector<Primitive> list) { Hierarchy::build(std::move(list), median_split); }
  bool closest(const Ray& ray, Hit& hit) const {
    if (!nodes.empty()) visit(0, ray, hit);
    return hit.primitive != nullptr;
  }

 private:
  void visit(int index, const Ray& ray, Hit& hit) const {
    const Node& node = nodes[index];
    if (node.box.entry(ray, INFINITY) == INFINITY) return;
    if (node.right > 0) {
      visit(index + 1, ray, hit);
      visit(node.right, ray, hit);
      return;
    }
    for (int i = node.first; i < node.last; ++i) primitives[i].intersect(ray, hit);
  }
};

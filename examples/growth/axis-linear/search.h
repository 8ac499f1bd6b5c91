// A hierarchy whose box test is WRONG ON PURPOSE: it does not divide by a component that is 0, and says that such a ray
// hits every box. The picture is right, but a ray along an axis asks all primitives.
#pragma once

#include <utility>
#include <vector>

#include "hierarchy.h"

struct Search : Hierarchy {
  static constexpr int kThreads = 1;
  void build(std::vector<Primitive> list) { Hierarchy::build(std::move(list), median_split); }
  bool closest(const Ray& ray, Hit& hit) const { return Hierarchy::closest(ray, hit, entry); }

 private:
  static double entry(const Box& box, const Ray& ray, double end) {
    const Vec d = ray.direction;
    if (d.x == 0 || d.y == 0 || d.z == 0) return ray.t_min;
    return box.entry(ray, end);
  }
};

// A hierarchy, each node split by the surface area heuristic.
#pragma once

#include <utility>
#include <vector>

#include "hierarchy.h"

struct Search : Hierarchy {
  static constexpr int kThreads = 1;
  void build(std::vector<Primitive> list) { Hierarchy::build(std::move(list), sah_split); }
};

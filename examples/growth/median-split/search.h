// A hierarchy, each node halved at the median.
#pragma once

#include <utility>
#include <vector>

#include "hierarchy.h"

struct Search : Hierarchy {
  static constexpr int kThreads = 1;
  void build(std::vector<Primitive> list) { Hierarchy::build(std::move(list), median_split); }
};

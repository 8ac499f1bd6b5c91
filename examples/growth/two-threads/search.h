// As sah, with two threads for the rows of the picture.
#pragma once

#include <utility>
#include <vector>

#include "hierarchy.h"

struct Search : Hierarchy {
  static constexpr int kThreads = 2;
  void build(std::vector<Primitive> list) { Hierarchy::build(std::move(list), sah_split); }
};

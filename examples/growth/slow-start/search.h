// As sah, after a second of work that has nothing to do with the scene.
#pragma once

#include <ctime>
#include <utility>
#include <vector>

#include "hierarchy.h"

struct Search : Hierarchy {
  static constexpr int kThreads = 1;
  Search() {
    while (std::clock() < CLOCKS_PER_SEC) {
    }
  }
  void build(std::vector<Primitive> list) { Hierarchy::build(std::move(list), sah_split); }
};

// A hierarchy that never splits anything, WRONG ON PURPOSE: the box of the centres starts with its maximum at
// +infinity. So its middle is infinite too, all lie below it, and a node with nothing in one half is a leaf.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "hierarchy.h"

struct Search : Hierarchy {
  static constexpr int kThreads = 1;
  void build(std::vector<Primitive> list) { Hierarchy::build(std::move(list), split_in_the_middle); }

 private:
  static int split_in_the_middle(std::vector<Primitive>& list, int first, int last) {
    if (last - first <= 4) return first;
    Box box;
    box.high = {INFINITY, INFINITY, INFINITY};
    for (int i = first; i < last; ++i) box.add(list[i].centre());
    const int axis = longest_axis(box.size());
    const double middle = (box.low[axis] + box.high[axis]) / 2;
    auto below = [&](const Primitive& p) { return p.centre()[axis] < middle; };
    return static_cast<int>(std::partition(list.begin() + first, list.begin() + last, below) - list.begin());
  }
};

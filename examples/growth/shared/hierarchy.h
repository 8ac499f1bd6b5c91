// A bounding volume hierarchy, and two ways to split its nodes.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "primitives.h"

struct Hierarchy {
  struct Node {
    Box box;
    int first, last, right = 0;  // the left child follows its parent; no right child: a leaf
  };
  std::vector<Primitive> primitives;
  std::vector<Node> nodes;

  // `split` orders a range of the primitives and says where its second half begins. One with nothing in a
  // half becomes a leaf.
  template <class Split>
  void build(std::vector<Primitive> list, Split split) {
    primitives = std::move(list);
    nodes.reserve(primitives.size());
    if (!primitives.empty()) build(0, static_cast<int>(primitives.size()), split);
  }

  bool closest(const Ray& ray, Hit& hit) const {
    return closest(ray, hit, [](const Box& box, const Ray& r, double end) { return box.entry(r, end); });
  }

  // `entry` says where a ray enters a box, as Box::entry.
  template <class Entry>
  bool closest(const Ray& ray, Hit& hit, Entry entry) const {
    std::vector<std::pair<int, double>>& stack = stack_of_this_thread();
    stack.clear();
    if (!nodes.empty()) stack.emplace_back(0, entry(nodes[0].box, ray, hit.t));
    while (!stack.empty()) {
      auto [index, t] = stack.back();
      stack.pop_back();
      if (t == INFINITY || t > hit.t) continue;
      const Node& node = nodes[index];
      if (node.right == 0) {
        for (int i = node.first; i < node.last; ++i) primitives[i].intersect(ray, hit);
        continue;
      }
      const std::pair<int, double> left{index + 1, entry(nodes[index + 1].box, ray, hit.t)};
      const std::pair<int, double> right{node.right, entry(nodes[node.right].box, ray, hit.t)};
      const bool left_first = left.second <= right.second;
      stack.push_back(left_first ? right : left);
      stack.push_back(left_first ? left : right);
    }
    return hit.primitive != nullptr;
  }

 private:
  static std::vector<std::pair<int, double>>& stack_of_this_thread() {
    thread_local std::vector<std::pair<int, double>> stack;
    return stack;
  }

  template <class Split>
  void build(int first, int last, Split split) {
    Node node{{}, first, last};
    for (int i = first; i < last; ++i) node.box.add(primitives[i].box());
    const Vec size = node.box.size(), pad = Vec{1, 1, 1} * (1e-9 * (size.x + size.y + size.z));
    node.box.low = node.box.low - pad, node.box.high = node.box.high + pad;  // so that rounding hides nothing
    const size_t index = nodes.size();
    nodes.push_back(node);
    const int middle = split(primitives, first, last);
    if (middle <= first || middle >= last) return;
    build(first, middle, split);
    nodes[index].right = static_cast<int>(nodes.size());
    build(middle, last, split);
  }
};

inline int longest_axis(Vec v) { return v.x >= v.y ? (v.x >= v.z ? 0 : 2) : (v.y >= v.z ? 1 : 2); }

inline Box box_of_centres(const std::vector<Primitive>& list, int first, int last) {
  Box box;
  for (int i = first; i < last; ++i) box.add(list[i].centre());
  return box;
}

// At the median of the centres along the longest side.
inline int median_split(std::vector<Primitive>& list, int first, int last) {
  if (last - first <= 4) return first;
  const int axis = longest_axis(box_of_centres(list, first, last).size()), middle = (first + last) / 2;
  std::nth_element(list.begin() + first, list.begin() + middle, list.begin() + last,
                   [axis](const Primitive& a, const Primitive& b) { return a.centre()[axis] < b.centre()[axis]; });
  return middle;
}

// Where (area times count) of both sides together is smallest, among the 15 borders of 16 equal bins.
inline int sah_split(std::vector<Primitive>& list, int first, int last) {
  if (last - first <= 2) return first;
  constexpr int kBins = 16;
  struct Bin {
    Box box;
    int count = 0;
    void add(const Bin& b) { box.add(b.box), count += b.count; }
    double cost() const {
      const Vec s = box.size();
      return count == 0 ? 0 : count * (s.x * s.y + s.y * s.z + s.z * s.x);
    }
  } bins[kBins], left[kBins], right;
  const Box centres = box_of_centres(list, first, last);
  const int axis = longest_axis(centres.size());
  const double low = centres.low[axis], width = centres.size()[axis];
  if (!(width > 0)) return (first + last) / 2;
  auto bin_of = [&](const Primitive& p) {
    return std::min(kBins - 1, static_cast<int>((p.centre()[axis] - low) / width * kBins));
  };
  for (int i = first; i < last; ++i) bins[bin_of(list[i])].add({list[i].box(), 1});
  left[0] = bins[0];
  for (int b = 1; b < kBins; ++b) left[b] = left[b - 1], left[b].add(bins[b]);
  double best = INFINITY;
  int border = 1;  // the first bin of the right side
  for (int b = kBins - 1; b > 0; --b) {
    right.add(bins[b]);
    const double cost = left[b - 1].cost() + right.cost();
    if (cost < best && right.count < last - first && right.count > 0) best = cost, border = b;
  }
  auto on_the_left = [&](const Primitive& p) { return bin_of(p) < border; };
  return static_cast<int>(std::partition(list.begin() + first, list.begin() + last, on_the_left) - list.begin());
}

#include "renderer/accel/wide_gatherer.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <new>
#include <vector>

namespace plumb {
namespace {

constexpr std::uint32_t kNodeLines = sizeof(Bvh8Node) / sizeof(CacheLine);
constexpr std::uint32_t kLeafLines = sizeof(Bvh8Leaf) / sizeof(CacheLine);
/// A subtree of no more groups is the work of one thread.
constexpr std::uint32_t kOneThread = 4096;

/// Of lines and of numbers of triangles: how many, or how many are taken already.
struct Space {
  std::uint32_t lines = 0, triangles = 0;
};

/// The children of a wide node, nodes first.
struct Children {
  std::array<std::uint32_t, 8> items;
  std::uint32_t count = 0, nodes = 0;
  std::uint32_t lines() const { return kNodeLines * nodes + kLeafLines * (count - nodes); }
};

/// A subtree for one thread, and where all below its root goes.
struct Part {
  std::uint32_t root, line = 0;
  Space space{};
};

/// The nodes above the parts are looked at first, then what the parts need is counted, then all is written.
class Gatherer {
 public:
  Gatherer(const BinaryTree& binary, Bvh8Tree& tree, WorkerPool& pool) : binary_(binary), tree_(tree), pool_(pool) {}

  void gather() {
    const Space all = plan();
    tree_.lines = MappedArray<CacheLine>(all.lines);
    tree_.triangles = TriangleNumbers(all.triangles, binary_.listed.mesh.triangles.size());
    Space used{kNodeLines, 0};
    std::size_t part = 0;
    write_top(0, 0, used, part);
    pool_.each(parts_.size(), [&](std::size_t i) {
      Space space = parts_[i].space;
      write(parts_[i].line, parts_[i].root, space);
    });
    // The ends of the last huge pages.
    tree_.lines.shrink(all.lines);
    tree_.triangles.trim();
  }

 private:
  const BinaryNode& node(std::uint32_t i) const { return binary_.nodes[i]; }
  bool is_for_one_thread(std::uint32_t i) const { return node(i).is_leaf() || node(i).inner.groups <= kOneThread; }

  /// Finds the parts and gives each its place. Returns what all takes.
  Space plan() {
    Space used{kNodeLines, 0};
    count_top(0, used);
    pool_.each(parts_.size(), [&](std::size_t i) { count(parts_[i].root, parts_[i].space); });
    for (Part& part : parts_) {
      const Space needed = part.space;
      part.space = used;
      used.lines += needed.lines;
      used.triangles += needed.triangles;
    }
    return used;
  }

  void count_top(std::uint32_t root, Space& space) {
    if (is_for_one_thread(root)) {
      parts_.push_back({root});
      return;
    }
    const Children children = count_children(root, space);
    for (std::uint32_t i = 0; i < children.nodes; ++i) count_top(children.items[i], space);
  }

  void count(std::uint32_t root, Space& space) const {
    const Children children = count_children(root, space);
    for (std::uint32_t i = 0; i < children.nodes; ++i) count(children.items[i], space);
  }

  Children count_children(std::uint32_t root, Space& space) const {
    const Children children = children_of(root);
    space.lines += children.lines();
    for (std::uint32_t i = children.nodes; i < children.count; ++i)
      space.triangles += node(children.items[i]).leaf.triangle_count;
    return children;
  }

  /// In the order of count_top.
  void write_top(std::uint32_t line, std::uint32_t root, Space& used, std::size_t& part) {
    if (is_for_one_thread(root)) {
      parts_[part++].line = line;
      return;
    }
    const Children children = children_of(root);
    const Bvh8Node& wide = write_node(line, children, used);
    for (std::uint32_t i = 0; i < children.nodes; ++i) write_top(wide.child[i] >> 1, children.items[i], used, part);
  }

  void write(std::uint32_t line, std::uint32_t root, Space& used) {
    const Children children = children_of(root);
    const Bvh8Node& wide = write_node(line, children, used);
    for (std::uint32_t i = 0; i < children.nodes; ++i) write(wide.child[i] >> 1, children.items[i], used);
  }

  /// The node and those of its children that are leaves.
  const Bvh8Node& write_node(std::uint32_t line, const Children& children, Space& used) {
    Bvh8Node& wide = make_at<Bvh8Node>(line);
    std::uint32_t next = used.lines;
    used.lines += children.lines();
    wide.child.fill(0);
    for (std::uint32_t i = 0; i < children.count; ++i) {
      const bool is_leaf = i >= children.nodes;
      wide.child[i] = next << 1 | static_cast<std::uint32_t>(is_leaf);
      if (is_leaf) write_leaf(make_at<Bvh8Leaf>(next), node(children.items[i]), used);
      next += is_leaf ? kLeafLines : kNodeLines;
    }
    set_boxes(wide, children);
    return wide;
  }

  template <class T>
  T& make_at(std::uint32_t line) {
    return *new (&tree_.lines[line]) T;
  }

  Children children_of(std::uint32_t root) const {
    Children children;
    if (node(root).is_leaf()) {  // a mesh that is one leaf
      children.items[children.count++] = root;
      return children;
    }
    collect(root, 8, children);
    const auto leaves = std::stable_partition(children.items.begin(), children.items.begin() + children.count,
                                              [&](std::uint32_t i) { return !node(i).is_leaf(); });
    children.nodes = static_cast<std::uint32_t>(leaves - children.items.begin());
    return children;
  }

  /// Adds the subtree as at most `room` children.
  void collect(std::uint32_t from, std::uint32_t room, Children& children) const {
    const std::uint32_t split = node(from).split(room);
    if (split == 0) {
      children.items[children.count++] = from;
      return;
    }
    collect(node(from).first, split, children);
    collect(node(from).first + 1, room - split, children);
  }

  void set_boxes(Bvh8Node& wide, const Children& children) const {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    for (std::uint32_t i = 0; i < 8; ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        auto& [low, high] = wide.sides[static_cast<std::size_t>(axis)];
        low[i] = i < children.count ? node(children.items[i]).box.low[axis] : kInfinity;
        high[i] = i < children.count ? node(children.items[i]).box.high[axis] : -kInfinity;
      }
    }
  }

  void write_leaf(Bvh8Leaf& leaf, const BinaryNode& from, Space& used) {
    // Lanes that nothing uses must not hold what slows arithmetic down.
    for (std::uint32_t i = 0; i < kLeafVertices; ++i) {
      const BoxSide p = binary_.vertices[from.leaf.vertices[i < from.leaf.vertex_count ? i : 0]];
      for (int axis = 0; axis < 3; ++axis) leaf.vertices[static_cast<std::size_t>(axis)][i] = p[axis];
    }
    leaf.corner = from.leaf.corner;
    leaf.first = used.triangles;
    leaf.present = static_cast<std::uint8_t>((1U << from.leaf.triangle_count) - 1);
    for (const TriangleGroup& group : binary_.groups.subspan(from.first, from.count))
      for (std::uint32_t i = group.first(); i < group.first() + group.count(); ++i)
        tree_.triangles.set(used.triangles++, binary_.listed[i]);
  }

  const BinaryTree& binary_;
  Bvh8Tree& tree_;
  WorkerPool& pool_;
  std::vector<Part> parts_;
};

}  // namespace

void gather_wide(const BinaryTree& binary, Bvh8Tree& tree, WorkerPool& pool) { Gatherer(binary, tree, pool).gather(); }

}  // namespace plumb

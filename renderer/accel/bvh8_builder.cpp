#include "renderer/accel/bvh8_builder.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <future>
#include <limits>
#include <new>
#include <vector>

#include "renderer/accel/binary_tree.h"
#include "renderer/accel/filter_ray.h"
#include "renderer/accel/frame_vertices.h"
#include "renderer/accel/in_parts.h"
#include "renderer/accel/triangle_groups.h"

namespace plumb {
namespace {

/// Gathers eight children at a time from the binary tree.
class Gatherer {
 public:
  Gatherer(const ListedTriangles& listed, const FrameVertices& vertices, std::span<const TriangleGroup> groups,
           std::span<const BinaryNode> binary, Bvh8Tree& tree, int threads)
      : listed_(listed), vertices_(vertices), groups_(groups), binary_(binary), tree_(tree), helpers_(threads - 1) {}

  void gather() {
    tree_.lines = MappedArray<CacheLine>(kNodeLines * binary_.size());
    tree_.triangles = MappedArray<std::uint32_t>(listed_.triangles.size());
    gather_node(0, 0, 0);
    tree_.lines.shrink(lines_);
  }

 private:
  static constexpr std::uint32_t kNodeLines = sizeof(Bvh8Node) / sizeof(CacheLine);
  static constexpr int kSharedDepth = 3;
  static constexpr std::uint32_t kLeafLines = sizeof(Bvh8Leaf) / sizeof(CacheLine);

  struct Children {
    std::array<std::uint32_t, 8> items;
    std::uint32_t count = 0, nodes = 0;
  };

  template <class T>
  T& make_at(std::uint32_t line) {
    return *new (&tree_.lines[line]) T;
  }

  /// Near the root a child goes to another thread, if one is free.
  void gather_node(std::uint32_t line, std::uint32_t root, int depth) {
    const Children children = children_of(root);
    Bvh8Node& node = make_at<Bvh8Node>(line);
    std::uint32_t next = lines_.fetch_add(kNodeLines * children.nodes + kLeafLines * (children.count - children.nodes));
    node.child.fill(0);
    for (std::uint32_t i = 0; i < children.count; ++i) {
      const bool is_leaf = i >= children.nodes;
      node.child[i] = next << 1 | static_cast<std::uint32_t>(is_leaf);
      if (is_leaf) fill_leaf(make_at<Bvh8Leaf>(next), binary_[children.items[i]]);
      next += is_leaf ? kLeafLines : kNodeLines;
    }
    set_boxes(node, children);
    std::vector<std::future<void>> others;
    for (std::uint32_t i = 0; i < children.nodes; ++i) {
      const auto gather_child = [this, line = node.child[i] >> 1, from = children.items[i], depth] {
        gather_node(line, from, depth + 1);
      };
      if (depth >= kSharedDepth || i + 1 == children.nodes) {
        gather_child();
      } else if (helpers_.fetch_sub(1) > 0) {
        others.push_back(std::async(std::launch::async, [this, gather_child] {
          gather_child();
          helpers_.fetch_add(1);
        }));
      } else {
        helpers_.fetch_add(1);
        gather_child();
      }
    }
    for (auto& other : others) other.get();
  }

  /// The children of a wide node, nodes first.
  Children children_of(std::uint32_t root) const {
    Children children;
    if (binary_[root].count > 0) {  // a mesh that is one leaf
      children.items[children.count++] = root;
      return children;
    }
    collect(root, 8, children);
    const auto leaves = std::stable_partition(children.items.begin(), children.items.begin() + children.count,
                                              [&](std::uint32_t i) { return binary_[i].count == 0; });
    children.nodes = static_cast<std::uint32_t>(leaves - children.items.begin());
    return children;
  }

  /// Adds the subtree as at most `room` children.
  void collect(std::uint32_t from, std::uint32_t room, Children& children) const {
    const BinaryNode& node = binary_[from];
    const std::uint32_t split = node.split[room - 1];
    if (split == 0) {
      children.items[children.count++] = from;
      return;
    }
    collect(node.first, split, children);
    collect(node.first + 1, room - split, children);
  }

  void set_boxes(Bvh8Node& node, const Children& children) const {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    for (std::uint32_t i = 0; i < 8; ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        auto& [low, high] = node.sides[static_cast<std::size_t>(axis)];
        low[i] = i < children.count ? binary_[children.items[i]].box.low[axis] : kInfinity;
        high[i] = i < children.count ? binary_[children.items[i]].box.high[axis] : -kInfinity;
      }
    }
  }

  void fill_leaf(Bvh8Leaf& leaf, const BinaryNode& from) {
    std::array<std::uint32_t, kLeafVertices> seen;
    std::uint32_t vertices = 0, slot = 0;
    const auto place = [&](std::uint32_t vertex) {
      const auto known = std::find(seen.begin(), seen.begin() + vertices, vertex) - seen.begin();
      if (known == vertices) {
        seen[vertices++] = vertex;
        const BoxSide p = vertices_[vertex];
        for (int axis = 0; axis < 3; ++axis)
          leaf.vertices[static_cast<std::size_t>(axis)][static_cast<std::size_t>(known)] = p[axis];
      }
      return static_cast<std::uint8_t>(known);
    };
    const auto groups = groups_.subspan(from.first, from.count);
    std::uint32_t count = 0;
    for (const TriangleGroup& group : groups) count += group.count();
    leaf.first = triangles_.fetch_add(count);
    leaf.present = static_cast<std::uint8_t>((1U << count) - 1);
    for (const TriangleGroup& group : groups) {
      for (const std::uint32_t triangle : listed_.triangles.subspan(group.first(), group.count())) {
        tree_.triangles[leaf.first + slot] = triangle;
        for (std::size_t corner = 0; corner < 3; ++corner)
          leaf.corner[corner][slot] = place(listed_.mesh.triangles[triangle][corner]);
        ++slot;
      }
    }
    // Lanes that nothing uses must not hold what slows arithmetic down.
    for (auto& row : leaf.vertices) std::fill(row.begin() + vertices, row.end(), row[0]);
  }

  const ListedTriangles& listed_;
  const FrameVertices& vertices_;
  std::span<const TriangleGroup> groups_;
  std::span<const BinaryNode> binary_;
  Bvh8Tree& tree_;
  std::atomic<std::uint32_t> lines_ = kNodeLines, triangles_ = 0;
  std::atomic<int> helpers_;
};

}  // namespace

Bvh8Tree build_bvh8(const TriangleMesh& mesh, const Bvh8Options& options) {
  Bvh8Tree tree;
  tree.frame = frame_of(mesh);
  const FrameVertices vertices(mesh, tree.frame, options.threads);
  set_filter_errors(tree.frame);
  tree.exact_vertices = tree.frame.vertex_error == 0 && tree.frame.factor == 1 && tree.frame.center == Point3{};
  if (!tree.frame.is_usable) return tree;
  TriangleGroups groups = group_triangles(mesh, vertices, options.threads);
  if (groups.groups.size() == 0) return tree;
  const ListedTriangles listed{mesh, groups.listed()};
  const std::span<TriangleGroup> all(groups.groups.data(), groups.groups.size());
  const MappedArray<BinaryNode> binary = build_binary_tree(listed, all, options.threads);
  Gatherer(listed, vertices, all, {binary.data(), binary.size()}, tree, options.threads).gather();
  return tree;
}

}  // namespace plumb

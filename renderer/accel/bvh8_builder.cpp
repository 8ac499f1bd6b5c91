#include "renderer/accel/bvh8_builder.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <future>
#include <limits>
#include <new>
#include <thread>
#include <vector>

#include "renderer/accel/binary_tree.h"
#include "renderer/accel/filter_ray.h"
#include "renderer/math/bounds3.h"

namespace plumb {
namespace {

/// Calls f(begin, end) for parts of 0 .. count - 1, one a thread.
template <class F>
void in_parts(std::size_t count, int threads, const F& f) {
  const std::size_t parts = count < 10000 ? 1 : static_cast<std::size_t>(threads);
  std::vector<std::jthread> others;
  for (std::size_t i = 1; i < parts; ++i) others.emplace_back([&, i] { f(count * i / parts, count * (i + 1) / parts); });
  f(0, count / parts);
}

bool is_finite(const Point3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// The frame in which the vertices are floats, and of moderate size.
FilterFrame frame_of(const TriangleMesh& mesh) {
  Bounds3 bounds;
  for (const Point3& p : mesh.positions)
    if (is_finite(p)) bounds.extend(p);
  FilterFrame frame;
  if (bounds.empty()) return frame;
  const auto reach_from = [&](const Point3& center) {
    double reach = 0;
    for (int axis = 0; axis < 3; ++axis)
      reach = std::max({reach, std::fabs(bounds.min[axis] - center[axis]), std::fabs(bounds.max[axis] - center[axis])});
    return reach;
  };
  double reach = reach_from({});
  const Point3 middle = bounds.center();
  // Far from the origin, as in [1000, 1001]: the difference of such numbers needs fewer digits.
  if (reach > 16 * reach_from(middle) && reach < 0x1p100) {
    for (int axis = 0; axis < 3; ++axis) frame.center[axis] = static_cast<double>(static_cast<float>(middle[axis]));
    reach = reach_from(frame.center);
  }
  if (!(reach > 0x1p-30 && reach < 0x1p30) && reach > 0) frame.factor = std::scalbn(1.0, std::clamp(-std::ilogb(reach), -1000, 1000));
  frame.reach = std::max(reach * frame.factor, 0x1p-30) * (1 + 0x1p-20);
  return frame;
}

/// The vertices in the frame, and how far rounding them to floats moved one on an axis at most.
class FrameVertices {
 public:
  FrameVertices(const TriangleMesh& mesh, FilterFrame& frame, int threads) : vertices_(mesh.positions.size()) {
    std::atomic<double> error = 0;
    in_parts(mesh.positions.size(), threads, [&](std::size_t begin, std::size_t end) {
      double largest = 0;
      for (std::size_t i = begin; i < end; ++i) largest = std::max(largest, set(i, mesh.positions[i], frame));
      for (double seen = error; seen < largest && !error.compare_exchange_weak(seen, largest);) {
      }
    });
    frame.vertex_error = error;
    if (error > 0 && frame.center != Point3{}) frame.vertex_error += 0x1p-52 * frame.reach;
  }
  BoxSide operator[](std::uint32_t i) const { return vertices_[i]; }

 private:
  double set(std::size_t i, const Point3& p, const FilterFrame& frame) {
    BoxSide vertex{};
    double error = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double moved = p[axis] - frame.center[axis];
      const double exact = moved * frame.factor;
      vertex[axis] = static_cast<float>(exact);
      // What the subtraction lost shows when it is undone.
      const double lost = std::fabs((frame.center[axis] + moved) - p[axis]) * frame.factor;
      const double off = std::fabs(static_cast<double>(vertex[axis]) - exact) + lost;
      if (off > error) error = off;  // not of NaN, whose triangles are left out
    }
    vertices_[i] = vertex;
    return std::isfinite(error) ? error : 0;
  }

  MappedArray<BoxSide> vertices_;
};

/// Gathers eight children at a time from the binary tree.
class Gatherer {
 public:
  Gatherer(const TriangleMesh& mesh, const FrameVertices& vertices, std::span<const TriangleBox> boxes, std::span<const BinaryNode> binary,
           Bvh8Tree& tree, int threads)
      : mesh_(mesh), vertices_(vertices), boxes_(boxes), binary_(binary), tree_(tree), helpers_(threads - 1) {}

  void gather() {
    tree_.lines = MappedArray<CacheLine>(kNodeLines * binary_.size());
    tree_.triangles = MappedArray<std::uint32_t>(boxes_.size());
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
    std::uint32_t vertices = 0;
    leaf.first = from.first;
    leaf.present = static_cast<std::uint8_t>((1U << from.count) - 1);
    for (std::uint32_t slot = 0; slot < from.count; ++slot) {
      const std::uint32_t triangle = boxes_[from.first + slot].triangle();
      tree_.triangles[from.first + slot] = triangle;
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::uint32_t vertex = mesh_.triangles[triangle][corner];
        std::uint32_t at = 0;
        while (at < vertices && seen[at] != vertex) ++at;
        if (at == vertices) {
          seen[vertices++] = vertex;
          const BoxSide p = vertices_[vertex];
          for (int axis = 0; axis < 3; ++axis) leaf.vertices[static_cast<std::size_t>(axis)][at] = p[axis];
        }
        leaf.corner[corner][slot] = static_cast<std::uint8_t>(at);
      }
    }
    // Lanes that nothing uses must not hold what slows arithmetic down.
    for (auto& row : leaf.vertices) std::fill(row.begin() + vertices, row.end(), row[0]);
  }

  const TriangleMesh& mesh_;
  const FrameVertices& vertices_;
  std::span<const TriangleBox> boxes_;
  std::span<const BinaryNode> binary_;
  Bvh8Tree& tree_;
  std::atomic<std::uint32_t> lines_ = kNodeLines;
  std::atomic<int> helpers_;
};

/// Those whose numbers are all finite, moved to the front.
std::span<TriangleBox> finite_ones(const TriangleMesh& mesh, std::span<TriangleBox> boxes) {
  if (std::ranges::all_of(mesh.positions, is_finite)) return boxes;
  const auto has_other = [&](const TriangleBox& box) {
    const auto& [a, b, c] = mesh.triangles[box.triangle()];
    return !(is_finite(mesh.positions[a]) && is_finite(mesh.positions[b]) && is_finite(mesh.positions[c]));
  };
  const auto others = std::ranges::remove_if(boxes, has_other);
  return boxes.first(boxes.size() - others.size());
}

}  // namespace

Bvh8Tree build_bvh8(const TriangleMesh& mesh, const Bvh8Options& options) {
  Bvh8Tree tree;
  tree.frame = frame_of(mesh);
  const FrameVertices vertices(mesh, tree.frame, options.threads);
  set_filter_errors(tree.frame);
  tree.exact_vertices = tree.frame.vertex_error == 0 && tree.frame.factor == 1 && tree.frame.center == Point3{};
  MappedArray<TriangleBox> boxes(mesh.triangles.size());
  in_parts(mesh.triangles.size(), options.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      FloatBox box;
      for (const std::uint32_t vertex : mesh.triangles[i]) box.extend(vertices[vertex]);
      boxes[i].box = box;
      boxes[i].set_triangle(static_cast<std::uint32_t>(i));
    }
  });
  const std::span<TriangleBox> all = finite_ones(mesh, {boxes.data(), boxes.size()});
  if (all.empty()) return tree;
  const MappedArray<BinaryNode> binary = build_binary_tree(mesh, all, options.threads);
  Gatherer(mesh, vertices, all, {binary.data(), binary.size()}, tree, options.threads).gather();
  return tree;
}

}  // namespace plumb

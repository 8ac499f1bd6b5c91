#include "renderer/accel/binary_tree.h"

#include <algorithm>
#include <atomic>
#include <limits>

#include "renderer/accel/bvh8_layout.h"
#include "renderer/accel/group_partition.h"

namespace plumb {
namespace {

/// Below so many levels, nodes are halved by count, so that paths stay short: 2^32 triangles have 32 levels more.
constexpr int kBalanced = 60;
/// A subtree of no more groups is the work of one thread.
constexpr std::uint32_t kOneThread = 4096;

/// A range of so many triangles is only a few leaves.
constexpr std::uint32_t kSoonLeaves = 32;

/// Hands out nodes of an array in pairs. Those who share an array take runs of it, so as not to wait for each other.
class NodePairs {
 public:
  NodePairs(std::atomic<std::uint32_t>& used, std::uint32_t run) : used_(used), run_(2 * run) {}
  std::uint32_t next() {
    if (next_ == end_) {
      next_ = used_.fetch_add(run_, std::memory_order_relaxed);
      end_ = next_ + run_;
    }
    next_ += 2;
    return next_ - 2;
  }

 private:
  std::atomic<std::uint32_t>& used_;
  std::uint32_t run_;
  std::uint32_t next_ = 0, end_ = 0;
};

class BinaryBuilder {
 public:
  BinaryBuilder(const ListedTriangles& listed, std::span<TriangleGroup> groups, WorkerPool& pool)
      : listed_(listed), groups_(groups), pool_(pool), nodes_(nodes_for(groups.size())) {}

  MappedArray<BinaryNode> build(const GroupRange& all) {
    build_subtree(0, all, 1);
    nodes_.shrink(used_);
    return std::move(nodes_);
  }

 private:
  static constexpr std::uint32_t kRun = 64;

  /// A tree's, and what is left over of runs: less than an eighth of the groups, in pairs.
  static std::size_t nodes_for(std::size_t groups) { return 1 + 2 * groups + groups / 4; }

  /// What one thread does, or shares.
  void build_subtree(std::uint32_t index, const GroupRange& range, int depth) {
    NodePairs pairs(used_, range.count() > kOneThread ? 1 : std::clamp(range.count() / 8, 1U, kRun));
    build_node(index, range, depth, pairs);
  }

  void build_node(std::uint32_t index, const GroupRange& range, int depth, NodePairs& pairs) {
    BinaryNode& node = nodes_[index];
    node.box = range.box;
    if (fill_leaf(node, range)) return;
    if (range.triangles <= kSoonLeaves) expect(range);
    const auto [left, right] = split_groups(groups_, range, depth >= kBalanced, pool_);
    const std::uint32_t first = pairs.next();
    node.first = first;
    node.count = 0;
    node.inner.groups = range.count();
    if (range.count() > kOneThread) {
      pool_.both([&] { build_subtree(first, left, depth + 1); }, [&] { build_subtree(first + 1, right, depth + 1); });
    } else {
      build_node(first, left, depth + 1, pairs);
      build_node(first + 1, right, depth + 1, pairs);
    }
    set_costs(node, nodes_[first], nodes_[first + 1]);
  }

  /// Asks for what its leaves will read, which lies about.
  void expect(const GroupRange& range) const {
    for (const TriangleGroup& group : groups_.subspan(range.begin, range.count()))
      if (listed_.triangles.empty()) __builtin_prefetch(&listed_.mesh.triangles[group.first()]);
  }

  /// Makes a leaf, if the range fits one.
  bool fill_leaf(BinaryNode& node, const GroupRange& range) const {
    if (range.triangles > kLeafTriangles) return false;
    BinaryNode::Leaf leaf{};
    std::uint32_t vertices = 0, slot = 0;
    for (const TriangleGroup& group : groups_.subspan(range.begin, range.count())) {
      for (std::uint32_t i = group.first(); i < group.first() + group.count(); ++i, ++slot) {
        const auto& corners = listed_.mesh.triangles[listed_[i]];
        for (std::size_t k = 0; k < 3; ++k) {
          std::uint32_t place = 0;
          while (place < vertices && leaf.vertices[place] != corners[k]) ++place;
          if (place == vertices) {
            if (vertices == kLeafVertices) return false;
            leaf.vertices[vertices++] = corners[k];
          }
          leaf.corner[k][slot] = static_cast<std::uint8_t>(place);
        }
      }
    }
    leaf.vertex_count = static_cast<std::uint8_t>(vertices);
    leaf.triangle_count = static_cast<std::uint8_t>(slot);
    node.leaf = leaf;
    node.first = range.begin;
    node.count = range.count();
    return true;
  }

  static void set_costs(BinaryNode& node, const BinaryNode& left, const BinaryNode& right) {
    BinaryNode::Inner& inner = node.inner;
    std::array<float, 8> on_left, on_right;
    for (std::size_t room = 1; room <= 8; ++room) {
      on_left[room - 1] = left.cost(room);
      on_right[room - 1] = right.cost(room);
    }
    for (std::size_t room = 2; room <= 8; ++room) {
      float least = std::numeric_limits<float>::infinity();
      std::size_t split = 1;
      for (std::size_t in_left = 1; in_left < room; ++in_left) {
        const float cost = on_left[in_left - 1] + on_right[room - in_left - 1];
        if (cost < least) {
          least = cost;
          split = in_left;
        }
      }
      inner.cost[room - 1] = least;
      inner.split[room - 1] = static_cast<std::uint8_t>(split);
    }
    // As a wide node of its own.
    inner.cost[0] = node.box.half_area() + inner.cost[7];
    inner.split[0] = 0;
    for (std::size_t room = 2; room <= 7; ++room) {
      if (inner.cost[0] > inner.cost[room - 1]) continue;
      inner.cost[room - 1] = inner.cost[0];
      inner.split[room - 1] = 0;
    }
  }

  const ListedTriangles& listed_;
  std::span<TriangleGroup> groups_;
  WorkerPool& pool_;
  MappedArray<BinaryNode> nodes_;
  std::atomic<std::uint32_t> used_ = 1;
};

}  // namespace

MappedArray<BinaryNode> build_binary_tree(const ListedTriangles& listed, std::span<TriangleGroup> groups,
                                          const GroupRange& all, WorkerPool& pool) {
  return BinaryBuilder(listed, groups, pool).build(all);
}

}  // namespace plumb

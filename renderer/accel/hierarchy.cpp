#include "renderer/accel/hierarchy.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plumb {

namespace {
double largest_coordinate(const Point3& p) { return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}); }
}  // namespace

SlabTest::SlabTest(const Ray& ray, double margin, double drift)
    : reciprocal{1 / ray.direction.x, 1 / ray.direction.y, 1 / ray.direction.z},
      negative{std::signbit(ray.direction.x), std::signbit(ray.direction.y), std::signbit(ray.direction.z)} {
  const double wider = margin * largest_coordinate(ray.origin) + drift;
  origin_above = ray.origin + Vec3{wider, wider, wider};
  origin_below = ray.origin + Vec3{-wider, -wider, -wider};
}

double largest_coordinate(const Bounds3& box) {
  return std::max(largest_coordinate(box.min), largest_coordinate(box.max));
}

Bounds3 widened(const Bounds3& box, double margin) {
  if (box.empty()) return box;
  const double wider = margin * largest_coordinate(box);
  return {box.min + Vec3{-wider, -wider, -wider}, box.max + Vec3{wider, wider, wider}};
}

namespace {

constexpr std::size_t kBins = 16;
constexpr std::uint32_t kLargestLeaf = 16;
/// What visiting a node costs, in primitive tests.
constexpr double kNodeCost = 0.5;

struct Bin {
  Bounds3 bounds;
  std::uint32_t count = 0;
};

struct Split {
  double cost = Bounds3::kInfinity;
  int axis = 0;
  std::size_t bin = 0;  // the last bin on the left
};

}  // namespace

class HierarchyBuilder {
 public:
  HierarchyBuilder(Hierarchy& hierarchy, std::span<const Bounds3> bounds) : hierarchy_(hierarchy) {
    for (std::uint32_t i = 0; i < bounds.size(); ++i) {
      boxes_.push_back(widened(bounds[i], SlabTest::kMargin));
      centers_.push_back(boxes_.back().center());
      if (!bounds[i].empty()) hierarchy_.order_.push_back(i);
    }
  }

  void build() {
    const auto count = static_cast<std::uint32_t>(hierarchy_.order_.size());
    if (count == 0) return;
    hierarchy_.nodes_.reserve(2 * static_cast<std::size_t>(count));
    hierarchy_.nodes_.emplace_back();
    build_node(0, 0, count, 1);
  }

 private:
  void build_node(std::uint32_t index, std::uint32_t begin, std::uint32_t end, int depth) {
    hierarchy_.depth_ = std::max(hierarchy_.depth_, depth);
    Bounds3 bounds, centers;
    for (std::uint32_t i = begin; i < end; ++i) {
      bounds.extend(boxes_[hierarchy_.order_[i]]);
      centers.extend(centers_[hierarchy_.order_[i]]);
    }
    hierarchy_.nodes_[index].bounds = bounds;
    const std::uint32_t count = end - begin;
    const Split split = best_split(begin, end, centers);
    const double leaf_cost = count * bounds.half_area();
    if (count == 1 || (count <= kLargestLeaf && !(kNodeCost * bounds.half_area() + split.cost < leaf_cost))) {
      hierarchy_.nodes_[index].first = begin;
      hierarchy_.nodes_[index].count = count;
      return;
    }

    std::uint32_t middle = begin;
    if (split.cost < Bounds3::kInfinity && depth < Hierarchy::kBalanced) {
      const auto left_end =
          std::partition(hierarchy_.order_.begin() + begin, hierarchy_.order_.begin() + end,
                         [&](std::uint32_t p) { return bin_of(p, split.axis, centers) <= split.bin; });
      middle = static_cast<std::uint32_t>(left_end - hierarchy_.order_.begin());
    }
    // Where all centres coincide, or the tree is too deep already, any half is as good as the other.
    if (middle == begin || middle == end) middle = begin + count / 2;

    const auto first = static_cast<std::uint32_t>(hierarchy_.nodes_.size());
    hierarchy_.nodes_.resize(hierarchy_.nodes_.size() + 2);
    hierarchy_.nodes_[index].first = first;
    hierarchy_.nodes_[index].axis = static_cast<std::uint32_t>(split.axis);
    build_node(first, begin, middle, depth + 1);
    build_node(first + 1, middle, end, depth + 1);
  }

  std::size_t bin_of(std::uint32_t primitive, int axis, const Bounds3& centers) const {
    const double extent = centers.max[axis] - centers.min[axis];
    const double place = (centers_[primitive][axis] - centers.min[axis]) / extent * kBins;
    return place >= kBins - 1 ? kBins - 1 : static_cast<std::size_t>(place);
  }

  Split best_split(std::uint32_t begin, std::uint32_t end, const Bounds3& centers) const {
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
      const double extent = centers.max[axis] - centers.min[axis];
      if (!(extent > 0) || !std::isfinite(extent)) continue;
      std::array<Bin, kBins> bins{};
      for (std::uint32_t i = begin; i < end; ++i) {
        const std::uint32_t primitive = hierarchy_.order_[i];
        Bin& bin = bins[bin_of(primitive, axis, centers)];
        bin.bounds.extend(boxes_[primitive]);
        ++bin.count;
      }
      // Cost of everything right of each boundary, then a sweep from the left.
      std::array<double, kBins> right_cost{};
      Bin right;
      for (std::size_t b = kBins - 1; b > 0; --b) {
        right.bounds.extend(bins[b].bounds);
        right.count += bins[b].count;
        right_cost[b - 1] = right.count * right.bounds.half_area();
      }
      Bin left;
      for (std::size_t b = 0; b + 1 < kBins; ++b) {
        left.bounds.extend(bins[b].bounds);
        left.count += bins[b].count;
        if (left.count == 0 || left.count == end - begin) continue;
        const double cost = left.count * left.bounds.half_area() + right_cost[b];
        if (cost < best.cost) best = {cost, axis, b};
      }
    }
    return best;
  }

  Hierarchy& hierarchy_;
  std::vector<Bounds3> boxes_;
  std::vector<Point3> centers_;
};

Hierarchy::Hierarchy(std::span<const Bounds3> bounds, double origin_margin) : origin_margin_(origin_margin) {
  HierarchyBuilder(*this, bounds).build();
}

}  // namespace plumb

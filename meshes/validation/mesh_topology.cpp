#include "meshes/validation/mesh_topology.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace plumb {
namespace {

/// Disjoint sets of numbers.
class Sets {
 public:
  explicit Sets(std::size_t count) {
    parent_.resize(count);
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    a = root(a), b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// A triangle's edge from corner i to the next, known as 3 * triangle + i, beside the higher of its two places.
struct EdgeUse {
  std::uint32_t high, corner;
  friend auto operator<=>(const EdgeUse&, const EdgeUse&) = default;
  std::uint32_t triangle() const { return corner / 3; }
  std::uint32_t next_corner() const { return corner % 3 == 2 ? corner - 2 : corner + 1; }
  std::uint32_t opposite_corner() const { return corner % 3 == 0 ? corner + 2 : corner - 1; }
};

class Topology {
 public:
  Topology(const TriangleMesh& mesh, std::span<const std::uint32_t> place_of, MeshReport& report)
      : mesh_(mesh),
        place_of_(place_of),
        report_(report),
        components_(mesh.triangles.size()),
        fans_(3 * mesh.triangles.size()) {}

  void check(const std::function<void(double)>& progress) {
    sort_edges(progress);
    const auto places = static_cast<std::uint32_t>(place_of_.size());
    for (std::uint32_t low = 0; low < places; ++low) {
      const std::span<EdgeUse> bucket(uses_.data() + starts_[low], starts_[low + 1] - starts_[low]);
      std::ranges::sort(bucket);
      for (auto first = bucket.begin(); first != bucket.end();) {
        const auto last =
            std::find_if(first, bucket.end(), [&](const EdgeUse& use) { return use.high != first->high; });
        see_edge(low, {first, last});
        first = last;
      }
      if (progress && low % (places / 64 + 1) == 0) progress(0.3 + 0.6 * low / places);
    }
    count_fans_and_components();
  }

 private:
  std::uint32_t place(std::uint32_t corner) const { return place_of_[mesh_.triangles[corner / 3][corner % 3]]; }
  bool is_proper(std::uint32_t triangle) const {
    const std::uint32_t a = place(3 * triangle), b = place(3 * triangle + 1), c = place(3 * triangle + 2);
    return a != b && b != c && c != a;
  }

  template <class See>
  void for_each_use(const See& see) const {
    const auto triangles = static_cast<std::uint32_t>(mesh_.triangles.size());
    for (std::uint32_t triangle = 0; triangle < triangles; ++triangle) {
      if (!is_proper(triangle)) continue;
      for (std::uint32_t corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
        const auto [low, high] = std::minmax({place(corner), place(EdgeUse{0, corner}.next_corner())});
        see(low, EdgeUse{high, corner});
      }
    }
  }

  /// Into buckets by the lower place: a counting sort.
  void sort_edges(const std::function<void(double)>& progress) {
    starts_.assign(place_of_.size() + 1, 0);
    for_each_use([&](std::uint32_t low, const EdgeUse&) { ++starts_[low + 1]; });
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    if (progress) progress(0.1);
    uses_.resize(starts_.back());
    std::vector<std::uint32_t> ends(starts_.begin(), starts_.end() - 1);
    for_each_use([&](std::uint32_t low, const EdgeUse& use) { uses_[ends[low]++] = use; });
    if (progress) progress(0.3);
  }

  bool is_forward(std::uint32_t low, const EdgeUse& use) const { return place(use.corner) == low; }

  /// All uses of one edge, by triangle.
  void see_edge(std::uint32_t low, std::span<const EdgeUse> uses) {
    ++report_.edges;
    const EdgeUse& first = uses.front();
    if (uses.size() == 1) report_.boundary_edges.add(first.triangle());
    if (uses.size() == 2 && is_forward(low, first) == is_forward(low, uses[1]))
      report_.misoriented_edges.add(first.triangle());
    if (uses.size() > 2) report_.edges_of_many.add(first.triangle());
    for (const EdgeUse& use : uses.subspan(1)) {
      components_.unite(first.triangle(), use.triangle());
      const bool same = is_forward(low, first) == is_forward(low, use);
      fans_.unite(first.corner, same ? use.corner : use.next_corner());
      fans_.unite(first.next_corner(), same ? use.next_corner() : use.corner);
    }
    find_duplicates(uses);
  }

  /// Triangles of the same places share the edge between the two lowest, and have the same place opposite to it.
  void find_duplicates(std::span<const EdgeUse> uses) {
    opposite_.clear();
    for (const EdgeUse& use : uses)
      if (const std::uint32_t third = place(use.opposite_corner()); third > use.high)
        opposite_.emplace_back(third, use.triangle());
    std::ranges::sort(opposite_);
    for (std::size_t i = 1; i < opposite_.size(); ++i)
      if (opposite_[i].first == opposite_[i - 1].first) report_.duplicate_triangles.add(opposite_[i].second);
  }

  void count_fans_and_components() {
    std::vector<std::uint8_t> fans(place_of_.size(), 0);  // 2 stands for more, too
    std::int64_t triangles = 0, used = 0;
    for (std::uint32_t triangle = 0; triangle < mesh_.triangles.size(); ++triangle) {
      if (!is_proper(triangle)) continue;
      ++triangles;
      report_.components += components_.root(triangle) == triangle;
      for (std::uint32_t corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
        if (std::uint8_t& count = fans[place(corner)]; fans_.root(corner) == corner && count < 2) ++count;
    }
    for (std::uint32_t i = 0; i < fans.size(); ++i) {
      used += fans[i] > 0;
      if (fans[i] > 1) report_.vertices_of_many_fans.add(i);
    }
    report_.euler_characteristic = used - static_cast<std::int64_t>(report_.edges) + triangles;
    report_.closed = report_.boundary_edges.count == 0 && triangles > 0;
    report_.manifold = report_.edges_of_many.count == 0 && report_.vertices_of_many_fans.count == 0;
    report_.oriented = report_.misoriented_edges.count == 0 && report_.edges_of_many.count == 0;
  }

  const TriangleMesh& mesh_;
  std::span<const std::uint32_t> place_of_;
  MeshReport& report_;
  /// Of triangles joined by edges; of corners joined by the edges at their place.
  Sets components_, fans_;
  std::vector<std::uint32_t> starts_;
  std::vector<EdgeUse> uses_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> opposite_;
};

}  // namespace

void check_topology(const TriangleMesh& mesh, std::span<const std::uint32_t> place_of,
                    const std::function<void(double)>& progress, MeshReport& report) {
  Topology(mesh, place_of, report).check(progress);
}

}  // namespace plumb

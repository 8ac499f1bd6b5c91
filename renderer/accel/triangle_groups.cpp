#include "renderer/accel/triangle_groups.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <vector>

#include "renderer/accel/in_parts.h"

namespace plumb {
namespace {

constexpr std::uint32_t kNone = ~0U;

/// Which vertices are joined by triangles.
class Parts {
 public:
  explicit Parts(const TriangleMesh& mesh) : parent_(mesh.positions.size()) {
    std::iota(parent_.begin(), parent_.end(), 0U);
    for (const auto& [a, b, c] : mesh.triangles) {
      join(a, b);
      join(a, c);
    }
  }
  /// The same for all vertices of a part.
  std::uint32_t of(std::uint32_t vertex) {
    while (parent_[vertex] != vertex) vertex = parent_[vertex] = parent_[parent_[vertex]];
    return vertex;
  }
  std::size_t size() const { return parent_.size(); }

 private:
  void join(std::uint32_t a, std::uint32_t b) {
    a = of(a);
    b = of(b);
    if (a < b) parent_[b] = a;
    if (b < a) parent_[a] = b;
  }

  std::vector<std::uint32_t> parent_;
};

class Grouper {
 public:
  Grouper(const TriangleMesh& mesh, const FrameVertices& vertices, int threads)
      : mesh_(mesh), vertices_(vertices), threads_(threads) {}

  TriangleGroups group() {
    const std::size_t count = mesh_.triangles.size();
    result_.triangles = MappedArray<std::uint32_t>(count);
    result_.groups = MappedArray<TriangleGroup>(count);
    Parts parts(mesh_);
    std::vector<std::uint32_t> part_vertices(parts.size());
    for (std::uint32_t v = 0; v < parts.size(); ++v) ++part_vertices[parts.of(v)];
    const bool has_small_parts = std::any_of(part_vertices.begin(), part_vertices.end(), [](std::uint32_t vertices) {
      return vertices >= 3 && vertices <= kLeafVertices;
    });
    if (has_small_parts) {
      by_part(parts, part_vertices);
    } else {
      singly();
    }
    result_.triangles.shrink(listed_);
    result_.groups.shrink(groups_);
    return std::move(result_);
  }

 private:
  /// All in order, in parts of the list; the few that are not finite are taken out afterwards.
  void singly() {
    const std::size_t count = mesh_.triangles.size();
    std::atomic<bool> all_finite = true;
    in_parts(count, threads_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const auto triangle = static_cast<std::uint32_t>(i);
        result_.triangles[i] = triangle;
        result_.groups[i].set(box_of(triangle), triangle, 1);
        if (!is_finite(triangle)) all_finite = false;
      }
    });
    listed_ = groups_ = static_cast<std::uint32_t>(count);
    if (all_finite) return;
    const auto groups = std::span(result_.groups.data(), count);
    const auto kept = std::remove_if(groups.begin(), groups.end(),
                                     [&](const TriangleGroup& group) { return !is_finite(group.first()); });
    groups_ = static_cast<std::uint32_t>(kept - groups.begin());
  }

  void by_part(Parts& parts, const std::vector<std::uint32_t>& part_vertices) {
    std::vector<std::uint32_t> last(parts.size(), kNone), before(mesh_.triangles.size(), kNone);
    for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
      if (!is_finite(i)) continue;
      const std::uint32_t part = parts.of(mesh_.triangles[i][0]);
      if (part_vertices[part] > kLeafVertices) {
        result_.triangles[listed_] = i;
        add_group(listed_++, 1);
      } else {
        before[i] = last[part];
        last[part] = i;
      }
    }
    for (const std::uint32_t triangle : last) {
      if (triangle == kNone) continue;
      const std::uint32_t first = listed_;
      for (std::uint32_t i = triangle; i != kNone; i = before[i]) result_.triangles[listed_++] = i;
      cut(first, listed_ - first);
    }
  }

  /// Into groups of nearly the same size.
  void cut(std::uint32_t first, std::uint32_t count) {
    const std::uint32_t pieces = (count + kLeafTriangles - 1) / kLeafTriangles;
    for (std::uint32_t i = 0; i < pieces; ++i) {
      const std::uint32_t begin = count * i / pieces;
      add_group(first + begin, count * (i + 1) / pieces - begin);
    }
  }

  void add_group(std::uint32_t first, std::uint32_t count) {
    FloatBox box;
    for (std::uint32_t i = first; i < first + count; ++i) box.extend(box_of(result_.triangles[i]));
    result_.groups[groups_++].set(box, first, count);
  }

  FloatBox box_of(std::uint32_t triangle) const {
    FloatBox box;
    for (const std::uint32_t vertex : mesh_.triangles[triangle]) box.extend(vertices_[vertex]);
    return box;
  }

  bool is_finite(std::uint32_t triangle) const {
    float sum = 0;
    for (const std::uint32_t vertex : mesh_.triangles[triangle]) {
      const BoxSide p = vertices_[vertex];
      sum += (p[0] + p[1]) + p[2];  // floats of moderate size: no finite ones overflow
    }
    return std::isfinite(sum);
  }

  const TriangleMesh& mesh_;
  const FrameVertices& vertices_;
  int threads_;
  TriangleGroups result_;
  std::uint32_t listed_ = 0, groups_ = 0;
};

}  // namespace

TriangleGroups group_triangles(const TriangleMesh& mesh, const FrameVertices& vertices, int threads) {
  return Grouper(mesh, vertices, threads).group();
}

}  // namespace plumb

#include "renderer/accel/triangle_groups.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "renderer/accel/mesh_parts.h"

namespace plumb {
namespace {

constexpr std::uint32_t kNone = ~0U;
/// So many triangles are worth another thread's while.
constexpr std::size_t kBlock = 4096;

class Grouper {
 public:
  Grouper(const TriangleMesh& mesh, const FrameVertices& vertices, WorkerPool& pool)
      : mesh_(mesh), vertices_(vertices), pool_(pool) {}

  TriangleGroups group() {
    result_.groups = MappedArray<TriangleGroup>(mesh_.triangles.size());
    const MeshParts parts(mesh_, pool_);
    if (parts.has_small())
      by_part(parts);
    else
      singly();
    result_.groups.shrink(groups_);
    return std::move(result_);
  }

 private:
  /// All in order, in blocks; where some are not finite, again without them.
  void singly() {
    const std::size_t count = mesh_.triangles.size();
    std::vector<GroupRange> blocks((count + kBlock - 1) / kBlock);
    pool_.blocks(count, kBlock, [&](std::size_t begin, std::size_t end) {
      GroupRange range;
      for (std::size_t i = begin; i < end; ++i) {
        const auto triangle = static_cast<std::uint32_t>(i);
        if (!is_finite(triangle)) continue;
        TriangleGroup& group = result_.groups[begin + range.end++];
        group.set(box_of(triangle), triangle, 1);
        range.add(group);
      }
      blocks[begin / kBlock] = range;
    });
    join(blocks);
  }

  /// Moves the groups of all blocks to the front.
  void join(const std::vector<GroupRange>& blocks) {
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const TriangleGroup* first = &result_.groups[i * kBlock];
      if (groups_ < i * kBlock) std::copy(first, first + blocks[i].count(), &result_.groups[groups_]);
      groups_ += blocks[i].count();
      result_.all.append(blocks[i]);
    }
    result_.all.end = groups_;
  }

  void by_part(const MeshParts& parts) {
    result_.triangles = MappedArray<std::uint32_t>(mesh_.triangles.size());
    std::vector<std::uint32_t> last(mesh_.positions.size(), kNone), before(mesh_.triangles.size(), kNone);
    for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
      if (!is_finite(i)) continue;
      const std::uint32_t part = parts.of(mesh_.triangles[i][0]);
      if (!parts.is_small(part)) {
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
    result_.triangles.shrink(listed_);
    result_.all.end = groups_;
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
    result_.groups[groups_].set(box, first, count);
    result_.all.add(result_.groups[groups_++]);
  }

  FloatBox box_of(std::uint32_t triangle) const {
    FloatBox box;
    for (const std::uint32_t vertex : mesh_.triangles[triangle]) box.extend(vertices_[vertex]);
    return box;
  }

  bool is_finite(std::uint32_t triangle) const {
    const auto& [a, b, c] = mesh_.triangles[triangle];
    const BoxSide sums = (vertices_[a] + vertices_[b]) + vertices_[c];
    return std::isfinite((sums[0] + sums[1]) + sums[2]);  // floats of moderate size: no finite ones overflow
  }

  const TriangleMesh& mesh_;
  const FrameVertices& vertices_;
  WorkerPool& pool_;
  TriangleGroups result_;
  std::uint32_t listed_ = 0, groups_ = 0;
};

}  // namespace

TriangleGroups group_triangles(const TriangleMesh& mesh, const FrameVertices& vertices, WorkerPool& pool) {
  return Grouper(mesh, vertices, pool).group();
}

}  // namespace plumb

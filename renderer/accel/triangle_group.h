#pragma once

#include <bit>
#include <cstdint>

#include "renderer/accel/float4.h"

namespace plumb {

/// Triangles that stay together, as the builder sees them: 32 bytes, the fourth lanes of the box' sides holding bits of
/// other numbers. They are `count` from `first` in a list of triangles.
struct TriangleGroup {
  FloatBox box;

  /// The box alone. Bits of whole numbers would be subnormal floats, and slow.
  FloatBox bounds() const {
    using Bits = std::int32_t __attribute__((vector_size(16)));
    constexpr Bits kThree{-1, -1, -1, 0};
    return {std::bit_cast<BoxSide>(std::bit_cast<Bits>(box.low) & kThree),
            std::bit_cast<BoxSide>(std::bit_cast<Bits>(box.high) & kThree)};
  }
  std::uint32_t first() const { return std::bit_cast<std::uint32_t>(static_cast<float>(box.low[3])); }
  std::uint32_t count() const { return std::bit_cast<std::uint32_t>(static_cast<float>(box.high[3])); }
  void set(const FloatBox& around, std::uint32_t first, std::uint32_t count) {
    box = around;
    box.low[3] = std::bit_cast<float>(first);
    box.high[3] = std::bit_cast<float>(count);
  }
};

/// Twice the centre of a box.
inline BoxSide center_of(const FloatBox& box) { return box.low + box.high; }

/// Groups from begin to end, and how many triangles they have together, with a box around them and one around what
/// center_of says of them.
struct GroupRange {
  std::uint32_t begin = 0, end = 0;
  std::uint32_t triangles = 0;
  FloatBox box{}, centers{};

  std::uint32_t count() const { return end - begin; }
  /// What a group adds, but for its place.
  void add(const TriangleGroup& group) {
    const FloatBox bounds = group.bounds();
    box.extend(bounds);
    centers.extend(center_of(bounds));
    triangles += group.count();
  }
  /// The groups of another range, which begins where this one ends.
  void append(const GroupRange& next) {
    box.extend(next.box);
    centers.extend(next.centers);
    triangles += next.triangles;
    end = next.end;
  }
};

}  // namespace plumb

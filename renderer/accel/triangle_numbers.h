#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "renderer/accel/mapped_array.h"

namespace plumb {

/// A list of numbers of a mesh's triangles: of three bytes each, where the mesh has no more than 2^24, else of four.
class TriangleNumbers {
  static_assert(std::endian::native == std::endian::little, "a number's first bytes are its lowest");

 public:
  TriangleNumbers() = default;
  /// `size` zeros, to be set to numbers below `triangles`.
  TriangleNumbers(std::size_t size, std::size_t triangles)
      : width_(triangles <= (1U << 24) ? 3 : 4),
        mask_(triangles <= (1U << 24) ? 0xFFFFFF : 0xFFFFFFFF),
        bytes_(size > 0 ? size * width_ + kBehind : 0) {}

  /// A number that is read when it is asked for, of a list that is still there.
  class Number {
   public:
    Number(const TriangleNumbers& list, std::size_t i) : list_(list), i_(i) {}
    operator std::uint32_t() const { return list_.at(i_); }

   private:
    const TriangleNumbers& list_;
    std::size_t i_;
  };

  Number operator[](std::size_t i) const { return {*this, i}; }
  /// Different ones may be set at the same time.
  void set(std::size_t i, std::uint32_t number) { std::memcpy(bytes_.data() + i * width_, &number, width_); }
  /// Gives back what the system mapped beyond the list, when all are set.
  void trim() { bytes_.shrink(bytes_.size()); }
  const std::byte* data() const { return bytes_.data(); }
  std::size_t bytes() const { return bytes_.size(); }

 private:
  std::uint32_t at(std::size_t i) const {
    std::uint32_t word;
    std::memcpy(&word, bytes_.data() + i * width_, sizeof word);
    return word & mask_;
  }

  /// The last is read as a whole word, too.
  static constexpr std::size_t kBehind = 1;

  std::size_t width_ = 4;
  std::uint32_t mask_ = 0xFFFFFFFF;
  MappedArray<std::byte> bytes_;
};

}  // namespace plumb

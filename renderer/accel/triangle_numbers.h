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

  /// A number that is read when it is asked for.
  class Number {
   public:
    Number(const std::byte* at, std::uint32_t mask) : at_(at), mask_(mask) {}
    operator std::uint32_t() const {
      std::uint32_t word;
      std::memcpy(&word, at_, sizeof word);
      return word & mask_;
    }

   private:
    const std::byte* at_;
    std::uint32_t mask_;
  };

  Number operator[](std::size_t i) const { return {bytes_.data() + i * width_, mask_}; }
  /// Different ones may be set at the same time.
  void set(std::size_t i, std::uint32_t number) { std::memcpy(bytes_.data() + i * width_, &number, width_); }
  const std::byte* data() const { return bytes_.data(); }
  std::size_t bytes() const { return bytes_.size(); }

 private:
  /// The last is read as a whole word, too.
  static constexpr std::size_t kBehind = 1;

  std::size_t width_ = 4;
  std::uint32_t mask_ = 0xFFFFFFFF;
  MappedArray<std::byte> bytes_;
};

}  // namespace plumb

#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace plumb {

/// Some of a picture's pixels, by number, row by row: a word of bits for 64 of them.
class PixelSet {
 public:
  static constexpr std::size_t kWordBits = 64;

  PixelSet() = default;
  /// None of so many pixels.
  explicit PixelSet(std::size_t pixels) : words_((pixels + kWordBits - 1) / kWordBits) {}

  void insert(std::size_t pixel) { words_[pixel / kWordBits] |= std::uint64_t{1} << pixel % kWordBits; }
  bool contains(std::size_t pixel) const { return (words_[pixel / kWordBits] >> pixel % kWordBits & 1) != 0; }
  std::int64_t count() const {
    std::int64_t sum = 0;
    for (const std::uint64_t word : words_) sum += std::popcount(word);
    return sum;
  }
  /// For loops over several sets of the same picture at once. Bits past the last pixel are 0.
  const std::vector<std::uint64_t>& words() const { return words_; }

 private:
  std::vector<std::uint64_t> words_;
};

}  // namespace plumb

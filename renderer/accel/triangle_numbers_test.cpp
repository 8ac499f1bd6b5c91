#include "renderer/accel/triangle_numbers.h"

#include <gtest/gtest.h>

namespace plumb {
namespace {

TEST(TriangleNumbers, KeepsEachNumberInAsFewBytesAsTheMeshNeeds) {
  struct Case {
    std::size_t triangles, bytes_each;
  };
  int kept = 0;
  for (const auto& [triangles, bytes_each] :
       {Case{1, 3}, {1000, 3}, {1U << 24, 3}, {(1U << 24) + 1, 4}, {1UL << 32, 4}}) {
    constexpr std::size_t kSize = 100;
    TriangleNumbers numbers(kSize, triangles);
    EXPECT_EQ(numbers.bytes(), bytes_each * kSize + 1) << triangles;
    const auto number = [&](std::size_t i) {
      return static_cast<std::uint32_t>(triangles - 1 - i * 2654435761 % triangles);
    };
    for (std::size_t i = 0; i < kSize; ++i) numbers.set((i * 37) % kSize, number((i * 37) % kSize));
    for (std::size_t i = 0; i < kSize; ++i, ++kept) EXPECT_EQ(numbers[i], number(i)) << triangles << " " << i;
  }
  EXPECT_EQ(kept, 500);
}

TEST(TriangleNumbers, OfNothingTakeNothing) {
  EXPECT_EQ(TriangleNumbers().bytes(), 0u);
  EXPECT_EQ(TriangleNumbers(0, 7).bytes(), 0u);
}

}  // namespace
}  // namespace plumb

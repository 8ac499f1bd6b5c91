#include "conformance/diagnosis/picture_change.h"

#include <gmock/gmock.h>

#include "conformance/diagnosis/synthetic_cases_for_tests.h"

namespace plumb {
namespace {

using enum PictureChange::Move;

/// The cases `a` to `d` and what something makes of them.
std::optional<PictureChange> found(const std::function<Levels(const std::string&, const Levels&)>& drawn_from) {
  std::deque<Levels> pictures;
  std::vector<DrawnCase> cases;
  for (const std::string id : {"a", "b", "c", "d"}) {
    const Levels& right = pictures.emplace_back(test_picture(id, no_change));
    const Levels& drawn = pictures.emplace_back(drawn_from(id, right));
    cases.push_back({right, drawn, kTestWidth, kTestHeight});
  }
  return find_picture_change(cases);
}

PictureChange::Move move_of(const PictureChange& change) {
  return found([&](const std::string&, const Levels& right) { return change.apply(right, kTestWidth, kTestHeight); })
      .value_or(PictureChange{})
      .move;
}

PictureChange moved(PictureChange::Move move) {
  PictureChange change{move, {}};
  for (std::size_t i = 0; i < 256; ++i) change.table[i] = static_cast<std::uint8_t>(i);
  return change;
}

TEST(PictureChange, MovesPixels) {
  const Levels levels{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};  // two rows of two
  EXPECT_EQ(moved(left_right).apply(levels, 2, 2), (Levels{4, 5, 6, 1, 2, 3, 10, 11, 12, 7, 8, 9}));
  EXPECT_EQ(moved(top_bottom).apply(levels, 2, 2), (Levels{7, 8, 9, 10, 11, 12, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(moved(red_blue).apply(levels, 2, 2), (Levels{3, 2, 1, 6, 5, 4, 9, 8, 7, 12, 11, 10}));
}

TEST(PictureChange, EachMoveIsFound) {
  for (const PictureChange::Move move : {left_right, top_bottom, red_blue}) EXPECT_EQ(move_of(moved(move)), move);
}

TEST(PictureChange, OtherLevelsAreFoundWithThoseBetweenThem) {
  const auto squared = [](std::size_t level) { return static_cast<std::uint8_t>(level * level / 255); };
  PictureChange change;
  for (std::size_t i = 0; i < 256; ++i) change.table[i] = squared(i);
  const auto seen =
      found([&](const std::string&, const Levels& right) { return change.apply(right, kTestWidth, kTestHeight); });
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->move, none);
  for (std::size_t i = 60; i <= 235; ++i) EXPECT_NEAR(seen->table[i], squared(i), 1) << i;
}

TEST(PictureChange, FewOtherPixelsDoNotHideIt) {
  const auto seen = found([&](const std::string& id, const Levels&) {
    return moved(left_right).apply(test_picture(id, speckles(3, 80, id, 0, 0, 64, 48, 90)), kTestWidth, kTestHeight);
  });
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->move, left_right);
}

TEST(PictureChange, NothingIsFoundWhereOneCaseIsDrawnOtherwise) {
  EXPECT_FALSE(found([](const std::string& id, const Levels& right) {
    return id == "c" ? right : moved(left_right).apply(right, kTestWidth, kTestHeight);
  }));
  EXPECT_FALSE(found([](const std::string& id, const Levels&) {
    return test_picture(id, patch("b", 0, 0, 30, 30, 50));  // its levels occur elsewhere, too
  }));
  EXPECT_FALSE(found([](const std::string&, const Levels& right) { return right; }));
}

}  // namespace
}  // namespace plumb

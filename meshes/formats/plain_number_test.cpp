#include "meshes/formats/plain_number.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <random>
#include <string>

#include "meshes/formats/text_cursor.h"

namespace plumb {
namespace {

/// Enough bytes behind a word for it to be looked at, none of them a digit's end.
std::string padded(const std::string& word, char behind = '\n') {
  return word + behind + std::string(static_cast<std::size_t>(kPlainNumberReach), '7');
}

/// What is taken of the word, which must be all of it or nothing.
bool takes(const std::string& word, double& value) {
  const std::string text = padded(word);
  const char* const end = take_plain_decimal(text.data(), value);
  EXPECT_TRUE(end == nullptr || end == text.data() + word.size()) << word;
  return end != nullptr;
}

/// What a correctly rounding reader says; NaN where it refuses the word.
double expected_of(const std::string& word) {
  double value = 0;
  return parse_number(word, value) ? value : std::nan("");
}

void expect_right(const std::string& word, int& taken) {
  double value = 0;
  if (!takes(word, value)) return;
  ++taken;
  const double expected = expected_of(word);
  ASSERT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(expected))
      << word << ": " << std::hexfloat << value << ", expected " << expected;
}

std::string digits(std::mt19937_64& random, std::size_t count) {
  std::string text;
  for (; count > 0; --count) text += static_cast<char>('0' + random() % 10);
  return text;
}

TEST(PlainNumber, TakesWholeDecimalsOfEveryShapeRoundedCorrectly) {
  std::mt19937_64 random(1);
  int cases = 0, taken = 0;
  for (std::size_t before = 0; before <= 9; ++before) {
    for (std::size_t behind = 0; behind <= 20; ++behind) {
      for (int i = 0; i < 500; ++i, ++cases) {
        const std::string sign = i % 5 == 0 ? "-" : i % 5 == 1 ? "+" : "";
        const std::string whole = digits(random, before), fraction = digits(random, behind);
        expect_right(sign + whole + (behind > 0 || i % 7 == 0 ? "." : "") + fraction, taken);
      }
    }
  }
  EXPECT_EQ(cases, 10 * 21 * 500);
  // Of 210 shapes, 143 have at most 8 digits before the point, at most 19 in all, and one at least; of those with 17 or
  // more, 1 in 500 is left to others.
  EXPECT_GT(taken, 143 * 499);
}

TEST(PlainNumber, TakesTheShortestDigitsOfFloatsAndDoubles) {
  std::mt19937_64 random(2);
  int cases = 0, floats = 0, doubles = 0;
  for (; cases < 200000; ++cases) {
    const double value = std::ldexp(static_cast<double>(random() >> 11) + 1, -53 + static_cast<int>(random() % 14) - 7);
    char word[32];
    expect_right({word, std::to_chars(word, word + 32, static_cast<float>(value), std::chars_format::fixed).ptr},
                 floats);
    double read = 0;
    const std::string text(word, std::to_chars(word, word + 32, value, std::chars_format::fixed).ptr);
    if (!takes(text, read)) continue;
    ++doubles;
    ASSERT_EQ(read, value) << text;
  }
  EXPECT_GT(floats, cases * 99 / 100);
  EXPECT_GT(doubles, cases * 9 / 10);
}

/// Digits that lie as near as 19 of them can to the middle between two doubles: there a wrong bound would show.
TEST(PlainNumber, IsRightBesideTheMiddleOfTwoDoubles) {
  std::mt19937_64 random(3);
  int cases = 0, settled = 0;
  for (unsigned places = 0; places <= 19; ++places) {
    for (int i = 0; i < 2000; ++i) {
      const std::uint64_t near = random() >> (random() % 11) | std::uint64_t{1} << 53;
      const long double middle = (static_cast<long double>(near >> 11) + 0.5L) * 0x1p11L;
      for (int step = -2; step <= 2; ++step, ++cases) {
        const std::uint64_t number = static_cast<std::uint64_t>(middle) + static_cast<std::uint64_t>(step);
        if (number >= 10000000000000000000U) continue;
        double value = 0;
        if (!divide_by_power_of_ten(number, places, value)) continue;
        ++settled;
        const std::string word = std::to_string(number) + "e-" + std::to_string(places);
        ASSERT_EQ(value, expected_of(word)) << word;
      }
    }
  }
  EXPECT_EQ(cases, 20 * 2000 * 5);
  EXPECT_GT(settled, cases / 4);
}

TEST(PlainNumber, LeavesFewNumbersToOthers) {
  std::mt19937_64 random(4);
  int refused = 0;
  constexpr int kCases = 100000;
  for (int i = 0; i < kCases; ++i) {
    double value = 0;
    refused +=
        !divide_by_power_of_ten(random() >> 1 | std::uint64_t{1} << 62, 1 + static_cast<unsigned>(i) % 19, value);
  }
  // 2 in 2^10 at most, so 195; four standard deviations are 56.
  EXPECT_LT(refused, 251);
  EXPECT_GT(refused, 0);
}

TEST(PlainNumber, RefusesWhatIsNotPlain) {
  for (const std::string word :
       {"",     "-",    "+",   ".",   "-.",   "+-1",   "--1", "1e5",       "1.5e-3",
        "1,5",  "0x10", "nan", "inf", "-inf", "1.2.3", "1-",  "123456789", "0.12345678901234567890",
        "1.5f", "\xff"}) {
    double value = 0;
    EXPECT_FALSE(takes(word, value)) << word;
    std::uint32_t index = 0;
    EXPECT_EQ(take_plain_whole(padded(word).data(), index), nullptr) << word;
  }
  std::uint32_t index = 0;
  for (const std::string word : {"-1", "+1", "1.", "1.0"})
    EXPECT_EQ(take_plain_whole(padded(word).data(), index), nullptr);
}

TEST(PlainNumber, TakesWholeNumbersBeforeAnyWhiteSpace) {
  std::mt19937_64 random(5);
  int cases = 0;
  for (const char space : {' ', '\t', '\n', '\v', '\f', '\r'}) {
    for (std::size_t length = 1; length <= 8; ++length) {
      for (int i = 0; i < 200; ++i, ++cases) {
        const std::string word = digits(random, length), text = padded(word, space);
        std::uint32_t value = 0;
        ASSERT_EQ(take_plain_whole(text.data(), value), text.data() + length) << word;
        ASSERT_EQ(value, std::stoul(word));
      }
    }
  }
  EXPECT_EQ(cases, 6 * 8 * 200);
  std::uint32_t value = 0;
  for (const char other : {'\0', '\b', '\x0e', '!', '/', ':', '\x80', '\xb0', '\xff'})
    EXPECT_EQ(take_plain_whole(padded("12", other).data(), value), nullptr);
}

/// Every byte before and behind a digit, in every place of the eight.
TEST(PlainNumber, RunsOfDigitsEndAtAnyOtherByte) {
  int cases = 0;
  for (unsigned length = 0; length < 8; ++length) {
    for (int byte = 0; byte < 256; ++byte) {
      if (byte >= '0' && byte <= '9') continue;
      std::string text = "98765432";
      text[length] = static_cast<char>(byte);
      const DigitRun run = digit_run(text.data());
      ASSERT_EQ(run.length, length) << byte;
      ASSERT_EQ(run.value, length == 0 ? 0 : std::stoul(text.substr(0, length)));
      ++cases;
    }
  }
  EXPECT_EQ(cases, 8 * 246);
  EXPECT_EQ(digit_run("98765432").length, 8U);
  EXPECT_EQ(digit_run("98765432").value, 98765432U);
}

}  // namespace
}  // namespace plumb

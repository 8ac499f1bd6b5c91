#include "conformance/subject/probe_numbers.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "conformance/subject/subject.h"

namespace plumb {
namespace {

using nlohmann::json;

std::string text_of(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

void expect_same_bits(double value) {
  const double back = json::parse(text_of(value)).get<double>();
  EXPECT_EQ(std::bit_cast<std::uint64_t>(back), std::bit_cast<std::uint64_t>(value)) << std::hexfloat << value;
}

TEST(ProbeNumbers, ReadBackToTheSameBits) {
  for (const double value : {0.0, -0.0, 1.0, -1.0, 1e17, 1e22, 0x1p53, std::numeric_limits<double>::denorm_min(),
                             std::numeric_limits<double>::max(), 0.1, 1e-7})
    expect_same_bits(value);
  std::mt19937_64 random(20240608);
  int finite = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    expect_same_bits(value);
    ++finite;
  }
  EXPECT_GT(finite, 99'000);
}

TEST(ProbeNumbers, AreNeverTakenForIntegers) {
  EXPECT_EQ(text_of(-0.0), "-0.0");
  EXPECT_EQ(text_of(3), "3.0");
  EXPECT_EQ(text_of(1e300), "1e+300");
  std::string text;
  append_triple(text, Vec3{1, 0.5, -2});
  EXPECT_EQ(text, "1.0,0.5,-2.0");
}

TEST(ProbeNumbers, AreTextWhereTheyAreNone) {
  EXPECT_EQ(text_of(std::numeric_limits<double>::infinity()), "\"inf\"");
  EXPECT_EQ(text_of(-std::numeric_limits<double>::infinity()), "\"-inf\"");
  EXPECT_EQ(text_of(std::nan("")), "\"nan\"");
  EXPECT_THROW(finite_number(json("nan"), "it"), SubjectFailure);
  EXPECT_EQ(finite_number(json(3), "it"), 3.0);
}

TEST(ProbeNumbers, ShowOnlyTheBeginningOfWhatIsLong) {
  EXPECT_EQ(shown(json(std::string(1000, 'x'))).size(), 43u);
  const std::string long_sentence = sentence_of(json("a\nb" + std::string(499, 'x') + "\u00e4\u00e4"), "it");
  EXPECT_EQ(long_sentence, "a b" + std::string(497, 'x') + " ...");
  const std::string cut = sentence_of(json(std::string(499, 'x') + "\u00e4\u00e4"), "it");
  EXPECT_EQ(cut, std::string(499, 'x') + " ...") << "no half of a letter";
}

}  // namespace
}  // namespace plumb

#include "reference/quotient.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace plumb {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The rule of IEEE 754 said anew: `rounded` is right if the exact value lies between the midpoints to its neighbours,
/// on a midpoint only if its last bit is 0. The largest finite number has 2 max - before as its upper neighbour.
template <class Float>
bool is_nearest(const mpq_class& exact, Float rounded) {
  constexpr Float kLargest = std::numeric_limits<Float>::max(), kInf = std::numeric_limits<Float>::infinity();
  const mpq_class beyond = 2 * mpq_class(kLargest) - mpq_class(std::nextafter(kLargest, Float(0)));
  const auto as_exact = [&](Float x) { return std::isinf(x) ? (x > 0 ? beyond : mpq_class(-beyond)) : mpq_class(x); };
  const auto even = [&](Float x) {
    int exponent = 0;
    const Float last_bit =
        std::max(std::ldexp(Float(1), (std::frexp(x, &exponent), exponent) - std::numeric_limits<Float>::digits),
                 std::numeric_limits<Float>::denorm_min());
    return std::isinf(x) || x == 0 || std::fmod(x / last_bit, Float(2)) == 0;
  };
  const auto on_side = [&](Float neighbour) {
    if (neighbour == rounded) return true;  // beyond infinity
    const mpq_class middle = (as_exact(rounded) + as_exact(neighbour)) / 2;
    const int side = neighbour > rounded ? cmp(middle, exact) : cmp(exact, middle);
    return side > 0 || (side == 0 && even(rounded));
  };
  return on_side(std::nextafter(rounded, kInf)) && on_side(std::nextafter(rounded, -kInf));
}

void expect_rounded(const mpq_class& exact) {
  const RoundedQuotient result = round_quotient(make_quotient(exact));
  const auto [below, above] = result.enclosure;
  if (below == above) {
    EXPECT_EQ(mpq_class(below), exact);
  } else {
    EXPECT_EQ(std::nextafter(below, kInfinity), above);
    EXPECT_TRUE(below == -kInfinity || mpq_class(below) < exact);
    EXPECT_TRUE(above == kInfinity || mpq_class(above) > exact);
  }
  EXPECT_TRUE(is_nearest(exact, result.to_double)) << std::hexfloat << result.to_double;
  EXPECT_TRUE(is_nearest(exact, result.to_float)) << std::hexfloat << result.to_float;
}

/// A double from anywhere in the range.
double any_double(std::mt19937_64& random) {
  return std::ldexp(static_cast<double>(random() >> 11), static_cast<int>(random() % 2080) - 1074 - 52);
}

TEST(Quotient, RoundsRandomFractions) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 3000; ++i) {
    const mpq_class n(any_double(random)), d(any_double(random));
    if (d == 0) continue;
    expect_rounded(n / d);
    expect_rounded(-n / d);
    ASSERT_FALSE(HasFailure()) << i;
  }
}

template <class Float>
int check_midpoints(double lowest_exponent, double highest_exponent) {
  std::mt19937_64 random(2);
  int count = 0;
  const auto exponent = [&] {
    return std::uniform_int_distribution<int>(int(lowest_exponent), int(highest_exponent))(random);
  };
  for (int i = 0; i < 1500; ++i) {
    const Float x = std::ldexp(static_cast<Float>(static_cast<double>(random() >> 12) * 0x1p-52 + 1), exponent());
    const Float next = std::nextafter(x, std::numeric_limits<Float>::infinity());
    if (std::isinf(next)) continue;
    const mpq_class middle = (mpq_class(x) + mpq_class(next)) / 2;
    mpq_class tiny(0x1p-1074);
    for (const mpq_class& exact :
         {middle, mpq_class(middle + tiny * tiny), mpq_class(middle - tiny * tiny), mpq_class(x),
          mpq_class(mpq_class(x) + tiny * tiny), mpq_class(mpq_class(x) - tiny * tiny)}) {
      expect_rounded(exact);
      expect_rounded(-exact);
      ++count;
    }
    if (testing::Test::HasFailure()) return 0;
  }
  return count;
}

TEST(Quotient, TiesGoToEvenAndNothingElseDoes) {
  EXPECT_GT(check_midpoints<double>(-60, 60), 8000);
  EXPECT_GT(check_midpoints<double>(-1074, -1020), 8000);
  EXPECT_GT(check_midpoints<double>(1000, 1023), 8000);
  EXPECT_GT(check_midpoints<float>(-60, 60), 8000);
  EXPECT_GT(check_midpoints<float>(-149, -120), 8000);
  EXPECT_GT(check_midpoints<float>(100, 127), 8000);
}

TEST(Quotient, OverflowsAndUnderflowsLikeIeee754) {
  const double largest = std::numeric_limits<double>::max(), smallest = 0x1p-1074;
  const auto rounded = [](const mpq_class& q) { return round_quotient(make_quotient(q)); };
  const mpq_class half_step = mpq_class(0x1p970);
  EXPECT_EQ(rounded(mpq_class(largest) + half_step - 1).to_double, largest);
  EXPECT_EQ(rounded(mpq_class(largest) + half_step - 1).enclosure, (Enclosure{largest, kInfinity}));
  EXPECT_EQ(rounded(mpq_class(largest) + half_step).to_double, kInfinity);
  EXPECT_EQ(rounded(mpq_class(largest) * 1000).enclosure, (Enclosure{largest, kInfinity}));
  EXPECT_EQ(rounded(mpq_class(largest) * -1000).enclosure, (Enclosure{-kInfinity, -largest}));
  EXPECT_EQ(rounded(mpq_class(largest) * largest * largest).to_double, kInfinity);
  EXPECT_EQ(rounded(mpq_class(smallest) / 2).to_double, 0);
  EXPECT_EQ(rounded(mpq_class(smallest) / 2).enclosure, (Enclosure{0, smallest}));
  EXPECT_EQ(rounded(mpq_class(smallest) * 3 / 5).to_double, smallest);
  EXPECT_EQ(rounded(mpq_class(-smallest) * smallest).enclosure, (Enclosure{-smallest, 0}));
  EXPECT_EQ(rounded(0).enclosure, (Enclosure{0, 0}));
  EXPECT_EQ(rounded(mpq_class(largest)).to_float, std::numeric_limits<float>::infinity());
}

TEST(Quotient, ComparesAcrossDenominators) {
  EXPECT_EQ(compare({2, 6}, {1, 3}), 0);
  EXPECT_EQ(compare({-2, 6}, {1, 3}), -1);
  EXPECT_EQ(compare({2, 6}, {333, 1000}), 1);
  EXPECT_EQ(compare(make_quotient(3, -4), {-3, 4}), 0);
}

TEST(Quotient, DirectionsHaveUnitLength) {
  EXPECT_EQ(round_direction({0, -7, 0}), (Normal3{0, -1, 0}));
  const mpz_class huge = mpz_class(1) << 5000;
  EXPECT_EQ(round_direction({3 * huge, 4 * huge, 0}), (Normal3{0.6, 0.8, 0}));
  EXPECT_EQ(round_direction({huge, 1, 0}), (Normal3{1, 0, 0}));
}

}  // namespace
}  // namespace plumb

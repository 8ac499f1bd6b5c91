#pragma once

#include <cmath>

namespace plumb {

/// Exact sums of doubles without heap, after [Shewchuk 1997]: a number is held as an unevaluated sum of doubles that do
/// not overlap, the smallest first, no zeros. All operations are exact as long as nothing overflows and no error term
/// falls below the smallest denormal. A sufficient condition: every double that enters is 0 or has a magnitude within
/// [kExpansionMin, kExpansionMax], and no result is of a higher degree than four in them. A double in that range is a
/// multiple of 2^-252, so all of degree four are multiples of 2^-1008, far above 2^-1074; and they stay below 2^900,
/// with 27 bits left for the splitting. Needs rounding to nearest even and a compiler that neither contracts nor
/// reorders.
inline constexpr double kExpansionMin = 0x1p-200;
inline constexpr double kExpansionMax = 0x1p200;

/// Whether a double may enter an expansion of degree four.
inline bool in_expansion_range(double x) {
  const double magnitude = std::abs(x);
  return x == 0 || (magnitude >= kExpansionMin && magnitude <= kExpansionMax);
}

/// The rounded result of an operation and its error: their sum is the exact result.
struct TwoDoubles {
  double high, low;
};

inline TwoDoubles two_sum(double a, double b) {
  const double high = a + b;
  const double b_part = high - a;
  const double a_part = high - b_part;
  return {high, (a - a_part) + (b - b_part)};
}

/// The same in three operations, where a is zero or |a| >= |b|.
inline TwoDoubles fast_two_sum(double a, double b) {
  const double high = a + b;
  return {high, b - (high - a)};
}

/// A double as two of 26 bits, of which all products are exact.
inline TwoDoubles split_in_halves(double a) {
  const double c = 0x8000001p0 * a;
  const double high = c - (c - a);
  return {high, a - high};
}

inline TwoDoubles two_product(double a, const TwoDoubles& a_halves, double b, const TwoDoubles& b_halves) {
  const double high = a * b;
  const double error =
      ((high - a_halves.high * b_halves.high) - a_halves.low * b_halves.high) - a_halves.high * b_halves.low;
  return {high, a_halves.low * b_halves.low - error};
}
inline TwoDoubles two_product(double a, double b) { return two_product(a, split_in_halves(a), b, split_in_halves(b)); }

/// Up to kCapacity doubles that do not overlap, by growing magnitude, none of them zero.
template <int kCapacity>
class Expansion {
 public:
  Expansion() : size_(0) {}  // the parts stay as they are: clearing hundreds of them would cost more than the sums
  Expansion(const Expansion& other) : size_(other.size_) {
    for (int i = 0; i < size_; ++i) part_[i] = other.part_[i];
  }
  Expansion& operator=(const Expansion&) = delete;

  int size() const { return size_; }
  double operator[](int i) const { return part_[i]; }
  /// The sign of the exact value: that of the largest part.
  int sign() const { return size_ == 0 ? 0 : part_[size_ - 1] > 0 ? 1 : -1; }
  /// Adds a part above all others; zero is dropped.
  void append(double part) {
    part_[size_] = part;
    size_ += part != 0;
  }
  void negate() {
    for (int i = 0; i < size_; ++i) part_[i] = -part_[i];
  }

 private:
  int size_;
  double part_[kCapacity + 1];  // one more, where a dropped zero is written
};

inline Expansion<2> exact_difference(double a, double b) {
  const TwoDoubles difference = two_sum(a, -b);
  Expansion<2> result;
  result.append(difference.low);
  result.append(difference.high);
  return result;
}

/// The parts merged by magnitude and added from below, each error kept.
template <int kM, int kN>
Expansion<kM + kN> operator+(const Expansion<kM>& e, const Expansion<kN>& f) {
  Expansion<kM + kN> sum;
  int i = 0, j = 0;
  double running = 0;
  while (i < e.size() || j < f.size()) {
    const bool from_e = j == f.size() || (i < e.size() && std::abs(e[i]) < std::abs(f[j]));
    const TwoDoubles step = two_sum(running, from_e ? e[i++] : f[j++]);
    sum.append(step.low);
    running = step.high;
  }
  sum.append(running);
  return sum;
}

template <int kM, int kN>
Expansion<kM + kN> operator-(const Expansion<kM>& e, Expansion<kN> f) {
  f.negate();
  return e + f;
}

template <int kM>
Expansion<2 * kM> operator*(const Expansion<kM>& e, double b) {
  Expansion<2 * kM> product;
  const TwoDoubles b_halves = split_in_halves(b);
  double running = 0;
  for (int i = 0; i < e.size(); ++i) {
    const TwoDoubles part = two_product(e[i], split_in_halves(e[i]), b, b_halves);
    const TwoDoubles low = two_sum(running, part.low);
    const TwoDoubles high = fast_two_sum(part.high, low.high);
    product.append(low.low);
    product.append(high.low);
    running = high.high;
  }
  product.append(running);
  return product;
}

template <int kM>
Expansion<4 * kM> operator*(const Expansion<kM>& e, const Expansion<2>& f) {
  const Expansion<2 * kM> low = f.size() > 0 ? e * f[0] : Expansion<2 * kM>();
  const Expansion<2 * kM> high = f.size() > 1 ? e * f[1] : Expansion<2 * kM>();
  return low + high;
}

}  // namespace plumb

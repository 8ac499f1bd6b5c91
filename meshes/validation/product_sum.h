#pragma once

#include <array>
#include <cstdint>

namespace plumb {

/// A sum of products of three doubles each, held without rounding: a fixed-point number wide enough for every such
/// product, from the smallest subnormal's cube to the largest double's, a so-called long accumulator [Kulisch 1981].
/// Where ExactSum is bound to a range of exponents, this is not, and however long a sum is, a term costs the same.
/// Fewer than 2^60 terms; infinity and NaN are not meant to come in.
class ProductSum {
 public:
  void add(double a, double b, double c = 1);
  void subtract(double a, double b, double c = 1) { add(-a, b, c); }
  /// -1, 0 or 1.
  int sign() const;

 private:
  void carry();

  /// Bits from 2^-3222 to 2^3072, 32 a digit, and room above for the carries of a long sum.
  static constexpr std::size_t kDigits = 200;
  std::array<std::int64_t, kDigits> digits_{};
  /// Additions to a digit since its carry was passed on; each is below 2^32.
  std::uint32_t pending_ = 0;
};

}  // namespace plumb

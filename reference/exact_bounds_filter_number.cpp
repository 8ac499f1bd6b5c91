#include "reference/exact_bounds_filter_number.h"

#include <algorithm>

namespace plumb {
namespace {

struct Pair {
  double hi, lo;
};

/// a + b = hi + lo without error, for any order of magnitudes; NaN if it overflows.
Pair exact_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// The upper 26 bits and the rest.
Pair halves(double a) {
  const double scaled = 0x1.0000002p27 * a;
  const double upper = scaled - (scaled - a);
  return {upper, a - upper};
}

/// a b = hi + lo without error unless lo underflows; NaN if a factor is beyond 2^995.
Pair exact_product(double a, double b) {
  const double product = a * b;
  const Pair x = halves(a), y = halves(b);
  return {product, ((x.hi * y.hi - product) + x.hi * y.lo + x.lo * y.hi) + x.lo * y.lo};
}

double next_up(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }
double next_down(double x) { return std::nextafter(x, -std::numeric_limits<double>::infinity()); }

}  // namespace

std::optional<double> FilterNumber::round_up() const {
  if (!std::isfinite(hi_) || !std::isfinite(lo_) || !std::isfinite(error_)) return std::nullopt;
  if (exact()) return lo_ > 0 ? next_up(hi_) : hi_;
  // The true value is hi + [lo - error, lo + error]: strictly above hi, or strictly below it, and not as far as the
  // next double. 3/4 of the gap leaves room for the rounding of the comparison.
  if (lo_ > error_ && lo_ + error_ < 0.75 * (next_up(hi_) - hi_)) return next_up(hi_);
  if (-lo_ > error_ && error_ - lo_ < 0.75 * (hi_ - next_down(hi_))) return hi_;
  return std::nullopt;
}

FilterNumber operator+(const FilterNumber& a, const FilterNumber& b) {
  const Pair high = exact_sum(a.hi_, b.hi_), low = exact_sum(a.lo_, b.lo_);
  const Pair middle = exact_sum(high.lo, low.hi);
  const Pair upper = exact_sum(high.hi, middle.hi);
  const Pair rest = exact_sum(low.lo, upper.lo);
  const Pair result = exact_sum(upper.hi, rest.hi);
  const double lost = std::fabs(middle.lo) + std::fabs(rest.lo);
  return {result.hi, result.lo, (a.error_ + b.error_ + lost) * FilterNumber::kSlack};
}

FilterNumber operator*(const FilterNumber& a, const FilterNumber& b) {
  if ((a.hi_ == 0 && a.exact()) || (b.hi_ == 0 && b.exact())) return {};
  const Pair product = exact_product(a.hi_, b.hi_);
  const Pair result = exact_sum(product.hi, product.lo + (a.hi_ * b.lo_ + a.lo_ * b.hi_));
  if (a.exact() && b.exact() && a.lo_ == 0 && b.lo_ == 0 && std::fabs(product.hi) >= FilterNumber::kSmall)
    return {result.hi, result.lo, 0};
  const double carried = a.error_ * b.most() + b.error_ * a.most();
  const double rounded = FilterNumber::kProduct * std::fabs(product.hi) + FilterNumber::kTiny;
  return {result.hi, result.lo, (carried + rounded) * FilterNumber::kSlack};
}

FilterNumber operator/(const FilterNumber& a, const FilterNumber& b) {
  const double least = b.least();
  if (!(least >= FilterNumber::kSmall)) return FilterNumber::undecided();
  // Long division by two digits; what remains, over b, is the error, a's and b's own included.
  const double first = a.hi_ / b.hi_;
  const FilterNumber remainder = a - first * b;
  const double second = remainder.hi_ / b.hi_;
  const Pair quotient = exact_sum(first, second);
  const FilterNumber rest = remainder - second * b;
  return {quotient.hi, quotient.lo, FilterNumber::error_of_quotient(rest.most(), least)};
}

FilterNumber sqrt(const FilterNumber& a) {
  if (a.hi_ == 0 && a.exact()) return {};
  if (!(a.hi_ >= FilterNumber::kSmall)) return FilterNumber::undecided();
  // One step of Newton's; |sqrt(a) - s| = |a - s^2| / (sqrt(a) + s) is at most what remains over s.
  const double first = std::sqrt(a.hi_);
  const FilterNumber remainder = a - FilterNumber(first) * first;
  const Pair root = exact_sum(first, remainder.hi_ / (2 * first));
  const FilterNumber result(root.hi, root.lo, 0);
  const FilterNumber rest = a - result * result;
  return {root.hi, root.lo, FilterNumber::error_of_quotient(rest.most(), root.hi)};
}

FilterNumber max(const FilterNumber& a, const FilterNumber& b) {
  if (!std::isfinite(a.hi_ + a.lo_ + a.error_ + b.hi_ + b.lo_ + b.error_)) return FilterNumber::undecided();
  const bool b_larger = a.hi_ < b.hi_ || (a.hi_ == b.hi_ && a.lo_ < b.lo_);
  const FilterNumber& larger = b_larger ? b : a;
  return {larger.hi_, larger.lo_, std::max(a.error_, b.error_)};
}

}  // namespace plumb

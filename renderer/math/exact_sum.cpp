#include "renderer/math/exact_sum.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace plumb {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The smallest double for which `holds`, which is monotone; `near` is a few doubles away at most.
template <class Holds>
double smallest(double near, const Holds& holds) {
  while (!holds(near)) near = std::nextafter(near, kInfinity);
  for (double below = std::nextafter(near, -kInfinity); holds(below); below = std::nextafter(below, -kInfinity))
    near = below;
  return near;
}

}  // namespace

ExactSum& ExactSum::add(double value) {
  if (count_ == kMost) compress();
  if (count_ == kMost) throw std::logic_error("an exact sum has more parts than doubles have bits");
  // Each part passes on the sum, rounded, and keeps what the rounding took away.
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const double part = parts_[i];
    const double sum = value + part;
    const double from_part = sum - value;
    const double rest = (value - (sum - from_part)) + (part - from_part);
    if (rest != 0) parts_[kept++] = rest;
    value = sum;
  }
  if (value != 0) parts_[kept++] = value;
  count_ = kept;
  return *this;
}

ExactSum& ExactSum::add_product(double a, double b) {
  const double product = a * b;
  if (product == 0) return *this;
  return add(std::fma(a, b, -product)).add(product);
}

ExactSum& ExactSum::operator+=(const ExactSum& other) {
  for (std::size_t i = 0; i < other.count_; ++i) add(other.parts_[i]);
  return *this;
}

ExactSum& ExactSum::operator-=(const ExactSum& other) {
  for (std::size_t i = 0; i < other.count_; ++i) add(-other.parts_[i]);
  return *this;
}

ExactSum operator*(const ExactSum& a, const ExactSum& b) {
  ExactSum product;
  for (std::size_t i = 0; i < a.count_; ++i)
    for (std::size_t k = 0; k < b.count_; ++k) product.add_product(a.parts_[i], b.parts_[k]);
  return product;
}

int ExactSum::sign() const {
  if (count_ == 0) return 0;
  return parts_[count_ - 1] > 0 ? 1 : -1;  // the largest part outweighs all others together
}

long double ExactSum::rounded() const {
  long double sum = 0;
  for (std::size_t i = 0; i < count_; ++i) sum += static_cast<long double>(parts_[i]);
  return sum;
}

void ExactSum::compress() {
  // From the largest part down, each takes in as much of the next as fits, and what does not fit goes on.
  std::array<double, kMost> spaced;
  std::size_t lowest = kMost;
  double carried = parts_[count_ - 1];
  for (std::size_t i = count_ - 1; i-- > 0;) {
    const double sum = carried + parts_[i];
    const double rest = parts_[i] - (sum - carried);
    if (rest != 0) spaced[--lowest] = sum;
    carried = rest != 0 ? rest : sum;
  }
  // Then up again, so that no two of them overlap.
  count_ = 0;
  for (std::size_t i = lowest; i < kMost; ++i) {
    const double sum = spaced[i] + carried;
    const double rest = carried - (sum - spaced[i]);
    if (rest != 0) parts_[count_++] = rest;
    carried = sum;
  }
  parts_[count_++] = carried;
}

double rounded_up(long double value) {
  const double nearest = static_cast<double>(value);
  return static_cast<long double>(nearest) < value ? std::nextafter(nearest, kInfinity) : nearest;
}

double rounded_up(const ExactSum& value) {
  if (value.is_single()) return static_cast<double>(value.rounded());
  return smallest(static_cast<double>(value.rounded()), [&](double x) { return (ExactSum(x) - value).sign() >= 0; });
}

double rounded_down(const ExactSum& value) { return 0.0 - rounded_up(ExactSum() - value); }

double rounded_up(const SumWithRoot& value) {
  const auto& [center, numerator, denominator, radicand] = value;
  const long double c = center.rounded();
  const long double root = std::fabs(numerator.rounded() / denominator.rounded()) * std::sqrt(radicand.rounded());
  // Six roundings of at most 2^-62 each, of terms that are not larger than these.
  const long double error = 0x1p-59L * (std::fabs(c) + root);
  const double up = rounded_up(c + root + error);
  if (rounded_up(c + root - error) == up) return up;

  const ExactSum squared_denominator = denominator * denominator;
  const ExactSum squared_root = numerator * numerator * radicand;
  long double near = c + root;
  if (c < 0) {  // the two cancel: instead (c^2 - root^2) / (c - root), whose numerator is exact
    near =
        (center * center * squared_denominator - squared_root).rounded() / (squared_denominator.rounded() * (c - root));
    if (near == 0) return 0;
  }
  // x >= center + root  <=>  x - center >= 0 and its square is not below that of the root.
  return smallest(static_cast<double>(near), [&](double x) {
    const ExactSum distance = ExactSum(x) - center;
    return distance.sign() >= 0 && (distance * distance * squared_denominator - squared_root).sign() >= 0;
  });
}

}  // namespace plumb

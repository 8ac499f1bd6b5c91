#include "renderer/math/support.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace plumb {
namespace {

bool in_exact_range(double x) {
  const double size = std::fabs(x);
  return size == 0 || (size >= 0x1p-120 && size <= 0x1p120);
}

bool in_exact_range(const AffineRow& row, const Point3& point) {
  return std::all_of(row.begin(), row.end(), [](double entry) { return in_exact_range(entry); }) &&
         in_exact_range(point.x) && in_exact_range(point.y) && in_exact_range(point.z);
}

ExactSum mapped(const AffineRow& row, const Point3& p) {
  return ExactSum(row[3]).add_product(row[0], p.x).add_product(row[1], p.y).add_product(row[2], p.z);
}

/// Upwards of the value of these terms, which long double holds without overflow, and of their roundings.
double roughly_up(std::initializer_list<long double> terms) {
  long double sum = 0, sizes = 0;
  for (const long double term : terms) {
    sum += term;
    sizes += std::fabs(term);
  }
  return std::nextafter(rounded_up(sum + 0x1p-56L * sizes), Bounds3::kInfinity);
}

long double wide_product(double a, double b) { return static_cast<long double>(a) * static_cast<long double>(b); }

}  // namespace

double highest(const AffineRow& row, const Point3& point) {
  if (in_exact_range(row, point)) return rounded_up(mapped(row, point));
  return roughly_up(
      {wide_product(row[0], point.x), wide_product(row[1], point.y), wide_product(row[2], point.z), row[3]});
}

double highest(const AffineRow& row, const Bounds3& box) {
  Point3 corner;
  for (int i = 0; i < 3; ++i) corner[i] = row[static_cast<std::size_t>(i)] > 0 ? box.max[i] : box.min[i];
  return highest(row, corner);
}

double highest(const AffineRow& row, const RoundBody& body) {
  const auto& [center, radius, dimensions, shift, numerator, denominator] = body;
  if (in_exact_range(row, center) && in_exact_range(radius) && in_exact_range(shift)) {
    SumWithRoot reach{mapped(row, center).add_product(row[2], shift), numerator * radius, denominator, {}};
    for (std::size_t i = 0; i < dimensions; ++i) reach.radicand.add_product(row[i], row[i]);
    return rounded_up(reach);
  }
  long double squares = 0;
  for (std::size_t i = 0; i < dimensions; ++i) squares += wide_product(row[i], row[i]);
  const long double taper = std::fabs(numerator.rounded() / denominator.rounded());
  return roughly_up({wide_product(row[0], center.x), wide_product(row[1], center.y), wide_product(row[2], center.z),
                     wide_product(row[2], shift), row[3], radius * taper * std::sqrt(squares)});
}

double about_highest(const AffineRow& row, const Bounds3& box) {
  double sum = row[3];
  double sizes = std::fabs(row[3]);
  for (int i = 0; i < 3; ++i) {
    const double entry = row[static_cast<std::size_t>(i)];
    const double term = entry * (entry > 0 ? box.max[i] : box.min[i]);
    sum += term;
    sizes += std::fabs(term);
  }
  // Three products and three sums are within gamma_4 of the terms' sizes [Higham 2002, section 3.1], 4u of them; 8u
  // covers the rounding of this sum too.
  return sum + 8 * 0x1p-53 * sizes;
}

}  // namespace plumb

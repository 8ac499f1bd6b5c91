#include "renderer/math/affine_product.h"

#include <cmath>

#include "renderer/math/exact_sum.h"
#include "renderer/math/rotation.h"

namespace plumb {

AffineProduct::AffineProduct() : entries_(entries_of(identity_matrix())) {}

AffineProduct& AffineProduct::translate(const Vec3& offset) { return multiply_by(entries_of(translation(offset))); }

AffineProduct& AffineProduct::scale(const Vec3& factors) { return multiply_by(entries_of(scaling(factors))); }

AffineProduct& AffineProduct::rotate_degrees(const Vec3& angles) {
  for (const int axis : {2, 1, 0}) {
    const auto [cos, sin] = precise_cos_sin_degrees(angles[axis]);
    const auto next = static_cast<std::size_t>((axis + 1) % 3);
    const auto after = static_cast<std::size_t>((axis + 2) % 3);
    Entries factor = entries_of(identity_matrix());
    factor[next][next] = factor[after][after] = {cos.high, cos.low};
    factor[next][after] = {-sin.high, -sin.low};
    factor[after][next] = {sin.high, sin.low};
    multiply_by(factor);
  }
  return *this;
}

AffineMatrix AffineProduct::rounded() const {
  AffineMatrix matrix;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 4; ++c) matrix[r][c] = entries_[r][c].high;
  return matrix;
}

AffineProduct::Entry AffineProduct::entry_of_product(const Entries& a, const Entries& b, std::size_t row,
                                                     std::size_t column) {
  double plain = column == 3 ? a[row][3].high : 0;
  ExactSum sum;
  for (std::size_t k = 0; k < 3; ++k) plain += a[row][k].high * b[k][column].high;
  if (!std::isfinite(plain)) return {plain, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    sum.add_product(a[row][k].high, b[k][column].high);
    sum.add_product(a[row][k].high, b[k][column].low);
    sum.add_product(a[row][k].low, b[k][column].high);
  }
  if (column == 3) sum.add(a[row][3].high).add(a[row][3].low);
  const double high = static_cast<double>(sum.rounded());
  return {high, static_cast<double>(sum.add(-high).rounded())};
}

AffineProduct::Entries AffineProduct::entries_of(const AffineMatrix& matrix) {
  Entries entries;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 4; ++c) entries[r][c].high = matrix[r][c];
  return entries;
}

AffineProduct& AffineProduct::multiply_by(const Entries& factor) {
  Entries product;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 4; ++c) product[r][c] = entry_of_product(entries_, factor, r, c);
  entries_ = product;
  return *this;
}

}  // namespace plumb

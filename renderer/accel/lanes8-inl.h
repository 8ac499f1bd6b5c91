// Eight floats at once, for whatever target Highway compiles this for; included once a target. Only what is named so is
// fused, where the target can: what is computed in floats rejects within bounds that hold for both, so a target may
// visit a node more than another, and finds the same hits.
#if defined(PLUMB_RENDERER_ACCEL_LANES8_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_RENDERER_ACCEL_LANES8_INL_H
#undef PLUMB_RENDERER_ACCEL_LANES8_INL_H
#else
#define PLUMB_RENDERER_ACCEL_LANES8_INL_H
#endif

#include <hwy/highway.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace plumb {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR

/// Four floats, one at a time.
struct Float4 {
  std::array<float, 4> v;
  template <class F>
  static HWY_INLINE Float4 each(const F& f) {
    return {{f(0U), f(1U), f(2U), f(3U)}};
  }
  friend HWY_INLINE Float4 operator+(Float4 p, Float4 q) {
    return each([&](std::size_t i) { return p.v[i] + q.v[i]; });
  }
  friend HWY_INLINE Float4 operator-(Float4 p, Float4 q) {
    return each([&](std::size_t i) { return p.v[i] - q.v[i]; });
  }
  friend HWY_INLINE Float4 operator*(Float4 p, Float4 q) {
    return each([&](std::size_t i) { return p.v[i] * q.v[i]; });
  }
};
HWY_INLINE Float4 operator/(Float4 p, Float4 q) {
  return Float4::each([&](std::size_t i) { return p.v[i] / q.v[i]; });
}
HWY_INLINE Float4 load4(const float* p) { return {{p[0], p[1], p[2], p[3]}}; }
HWY_INLINE Float4 all4(float value) { return {{value, value, value, value}}; }
HWY_INLINE void store4(Float4 p, float* to) {
  for (std::size_t i = 0; i < 4; ++i) to[i] = p.v[i];
}
HWY_INLINE std::uint32_t at_most4(Float4 p, Float4 q) {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < 4; ++i) bits |= static_cast<std::uint32_t>(p.v[i] <= q.v[i]) << i;
  return bits;
}
HWY_INLINE Float4 low4(Float4 p, Float4 q) {
  return Float4::each([&](std::size_t i) { return p.v[i] < q.v[i] ? p.v[i] : q.v[i]; });
}
HWY_INLINE Float4 high4(Float4 p, Float4 q) {
  return Float4::each([&](std::size_t i) { return p.v[i] > q.v[i] ? p.v[i] : q.v[i]; });
}
HWY_INLINE Float4 size4(Float4 p) {
  return Float4::each([&](std::size_t i) { return p.v[i] < 0 ? -p.v[i] : p.v[i]; });
}
HWY_INLINE Float4 negative4(Float4 p) {
  return Float4::each([&](std::size_t i) { return -p.v[i]; });
}
HWY_INLINE Float4 negated_like4(Float4 p, Float4 of) {
  return Float4::each([&](std::size_t i) { return std::signbit(of.v[i]) ? -p.v[i] : p.v[i]; });
}

#else

using Four = hn::FixedTag<float, 4>;
using Float4 = hn::Vec<Four>;
HWY_INLINE Float4 load4(const float* p) { return hn::LoadU(Four(), p); }

#endif

#if HWY_TARGET != HWY_SCALAR && HWY_MAX_BYTES >= 32  // in one register

using Eight = hn::FixedTag<float, 8>;
using Float8 = hn::Vec<Eight>;
using Lanes8 = hn::Indices256<float>;

HWY_INLINE Float8 load8(const float* p) { return hn::LoadU(Eight(), p); }
HWY_INLINE Float8 all8(float value) { return hn::Set(Eight(), value); }
HWY_INLINE hn::Vec<hn::FixedTag<std::int32_t, 8>> words8(const std::uint8_t* p) {
  const hn::FixedTag<std::uint8_t, 8> bytes;
  const hn::FixedTag<std::int32_t, 8> words;
  return hn::PromoteTo(words, hn::LoadU(bytes, p));
}
HWY_INLINE Lanes8 lanes_from(const std::uint8_t* p) { return hn::IndicesFromVec(Eight(), words8(p)); }
HWY_INLINE Float8 taken(Float8 v, Lanes8 lanes) { return hn::TableLookupLanes(v, lanes); }
HWY_INLINE void store8(Float8 v, float* p) { hn::StoreU(v, Eight(), p); }
HWY_INLINE std::uint32_t at_most(Float8 a, Float8 b) {
  std::uint8_t bits = 0;
  hn::StoreMaskBits(Eight(), hn::Le(a, b), &bits);
  return bits;
}
HWY_INLINE Float8 product_plus(Float8 a, Float8 b, Float8 c) { return hn::MulAdd(a, b, c); }
HWY_INLINE Float8 product_less(Float8 a, Float8 b, Float8 c) { return hn::MulSub(a, b, c); }
HWY_INLINE Float8 less_product(Float8 c, Float8 a, Float8 b) { return hn::NegMulAdd(a, b, c); }
HWY_INLINE Float8 quotient(Float8 a, Float8 b) { return a / b; }
HWY_INLINE Float8 low(Float8 a, Float8 b) { return hn::Min(a, b); }
HWY_INLINE Float8 high(Float8 a, Float8 b) { return hn::Max(a, b); }
HWY_INLINE Float8 size_of(Float8 a) { return hn::Abs(a); }
HWY_INLINE Float8 negative(Float8 a) { return hn::Neg(a); }
HWY_INLINE Float8 negated_like(Float8 a, Float8 of) { return hn::Xor(a, hn::AndNot(hn::Abs(of), of)); }
/// No two lanes are equal: their numbers take the place of the last three bits, of numbers >= 0.
HWY_INLINE Float8 told_apart(Float8 a) {
  const hn::FixedTag<std::uint32_t, 8> words;
  return hn::BitCast(Eight(), hn::Or(hn::AndNot(hn::Set(words, 7U), hn::BitCast(words, a)), hn::Iota(words, 0U)));
}

#else  // in two

#if HWY_TARGET != HWY_SCALAR
HWY_INLINE Float4 all4(float value) { return hn::Set(Four(), value); }
HWY_INLINE void store4(Float4 p, float* to) { hn::StoreU(p, Four(), to); }
HWY_INLINE std::uint32_t at_most4(Float4 p, Float4 q) {
  std::uint8_t bits = 0;
  hn::StoreMaskBits(Four(), hn::Le(p, q), &bits);
  return bits;
}
HWY_INLINE Float4 low4(Float4 p, Float4 q) { return hn::Min(p, q); }
HWY_INLINE Float4 high4(Float4 p, Float4 q) { return hn::Max(p, q); }
HWY_INLINE Float4 size4(Float4 p) { return hn::Abs(p); }
HWY_INLINE Float4 negative4(Float4 p) { return hn::Neg(p); }
HWY_INLINE Float4 negated_like4(Float4 p, Float4 of) { return hn::Xor(p, hn::AndNot(hn::Abs(of), of)); }
#endif

struct Float8 {
  Float4 a, b;
  friend HWY_INLINE Float8 operator+(Float8 p, Float8 q) { return {p.a + q.a, p.b + q.b}; }
  friend HWY_INLINE Float8 operator-(Float8 p, Float8 q) { return {p.a - q.a, p.b - q.b}; }
  friend HWY_INLINE Float8 operator*(Float8 p, Float8 q) { return {p.a * q.a, p.b * q.b}; }
};
/// Which of eight lanes each lane takes.
using Lanes8 = const std::uint8_t*;

HWY_INLINE Float8 load8(const float* p) { return {load4(p), load4(p + 4)}; }
HWY_INLINE Float8 all8(float value) { return {all4(value), all4(value)}; }
HWY_INLINE Lanes8 lanes_from(const std::uint8_t* p) { return p; }
HWY_INLINE void store8(Float8 v, float* p) {
  store4(v.a, p);
  store4(v.b, p + 4);
}
HWY_INLINE Float8 taken(Float8 v, Lanes8 lanes) {
  std::array<float, 8> from, to;
  store8(v, from.data());
  for (std::size_t i = 0; i < 8; ++i) to[i] = from[lanes[i]];
  return load8(to.data());
}
/// A bit for each lane in which p <= q.
HWY_INLINE std::uint32_t at_most(Float8 p, Float8 q) { return at_most4(p.a, q.a) | at_most4(p.b, q.b) << 4; }
/// p q + r, p q - r and r - p q, in one rounding where the target has that, in two otherwise.
HWY_INLINE Float8 product_plus(Float8 p, Float8 q, Float8 r) { return p * q + r; }
HWY_INLINE Float8 product_less(Float8 p, Float8 q, Float8 r) { return p * q - r; }
HWY_INLINE Float8 less_product(Float8 r, Float8 p, Float8 q) { return r - p * q; }
HWY_INLINE Float8 quotient(Float8 p, Float8 q) { return {p.a / q.a, p.b / q.b}; }
HWY_INLINE Float8 low(Float8 p, Float8 q) { return {low4(p.a, q.a), low4(p.b, q.b)}; }
HWY_INLINE Float8 high(Float8 p, Float8 q) { return {high4(p.a, q.a), high4(p.b, q.b)}; }
HWY_INLINE Float8 size_of(Float8 p) { return {size4(p.a), size4(p.b)}; }
HWY_INLINE Float8 negative(Float8 p) { return {negative4(p.a), negative4(p.b)}; }
HWY_INLINE Float8 told_apart(Float8 p) {
  std::array<float, 8> v;
  store8(p, v.data());
  for (std::uint32_t i = 0; i < 8; ++i) v[i] = std::bit_cast<float>((std::bit_cast<std::uint32_t>(v[i]) & ~7U) | i);
  return load8(v.data());
}
/// p, or -p where `of` is negative.
HWY_INLINE Float8 negated_like(Float8 p, Float8 of) { return {negated_like4(p.a, of.a), negated_like4(p.b, of.b)}; }

#endif

}  // namespace HWY_NAMESPACE
}  // namespace plumb
HWY_AFTER_NAMESPACE();

#endif

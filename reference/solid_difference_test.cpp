#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <sstream>

#include "reference/solid_cases_for_tests.h"

namespace plumb {
namespace {

/// So that -0 and 0 differ.
bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

template <class Triple>
std::string text(const Triple& p) {
  std::ostringstream out;
  out << std::hexfloat << "(" << p.x << ", " << p.y << ", " << p.z << ")";
  return out.str();
}

template <class Triple>
bool same_bits(const Triple& a, const Triple& b) {
  return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}

class Differences {
 public:
  Differences() { out_ << std::hexfloat; }
  template <class T>
  void check(const char* name, const T& a, const T& b, bool same) {
    if (!same) out_ << name << ": " << a << " against " << b << "; ";
  }
  std::string text() const { return out_.str(); }

 private:
  std::ostringstream out_;
};

void compare(const ExactCrossing& a, const ExactCrossing& b, Differences& found) {
  found.check("t below", a.t.below, b.t.below, same_bits(a.t.below, b.t.below));
  found.check("t above", a.t.above, b.t.above, same_bits(a.t.above, b.t.above));
  found.check("t double", a.t_double, b.t_double, same_bits(a.t_double, b.t_double));
  found.check("t float", a.t_float, b.t_float, same_bits(double{a.t_float}, double{b.t_float}));
  found.check("place", static_cast<int>(a.place), static_cast<int>(b.place), a.place == b.place);
  found.check("free", a.free, b.free, a.free == b.free);
  found.check("part", a.part, b.part, a.part == b.part);
  found.check("u", a.u, b.u, same_bits(a.u, b.u));
  found.check("v", a.v, b.v, same_bits(a.v, b.v));
  found.check("position", text(a.position), text(b.position), same_bits(a.position, b.position));
  found.check("normal", text(a.normal), text(b.normal), same_bits(a.normal, b.normal));
}

}  // namespace

std::string difference(const ExactHit& a, const ExactHit& b) {
  Differences found;
  found.check("class", static_cast<int>(a.hit_class), static_cast<int>(b.hit_class), a.hit_class == b.hit_class);
  found.check("inside", a.inside, b.inside, a.inside == b.inside);
  found.check("crossings", a.crossings.size(), b.crossings.size(), a.crossings.size() == b.crossings.size());
  for (std::size_t i = 0; i < a.crossings.size() && i < b.crossings.size(); ++i)
    compare(a.crossings[i], b.crossings[i], found);
  return found.text();
}

std::string describe(const PlacedShape& placed, const Ray& ray) {
  const Shape& s = placed.shape;
  std::ostringstream out;
  out << std::hexfloat << "kind " << static_cast<int>(s.kind) << " center " << text(s.center) << " radius " << s.radius
      << " height " << s.height << " tip " << s.tip_z << " min " << text(s.min) << " max " << text(s.max)
      << "\n  matrix";
  for (const auto& row : placed.world_from_object)
    for (const double entry : row) out << " " << entry;
  out << "\n  origin " << text(ray.origin) << " direction " << text(ray.direction) << " range " << ray.t_min << " "
      << ray.t_max;
  return out.str();
}

TEST(SolidDifference, SeesEveryField) {
  ExactHit hit;
  hit.crossings.resize(1);
  EXPECT_EQ(difference(hit, hit), "");
  const auto changed = [&](auto change) {
    ExactHit other = hit;
    change(other);
    return difference(hit, other) != "";
  };
  EXPECT_TRUE(changed([](ExactHit& h) { h.hit_class = HitClass::hit; }));
  EXPECT_TRUE(changed([](ExactHit& h) { h.inside = true; }));
  EXPECT_TRUE(changed([](ExactHit& h) { h.crossings.clear(); }));
  EXPECT_TRUE(changed([](ExactHit& h) { h.crossings[0].t.above = 1; }));
  EXPECT_TRUE(changed([](ExactHit& h) { h.crossings[0].t_double = -0.0; }));
  EXPECT_TRUE(changed([](ExactHit& h) { h.crossings[0].t_float = 1; }));
  EXPECT_TRUE(changed([](ExactHit& h) { h.crossings[0].place = RangePlace::at_max; }));
  EXPECT_TRUE(changed([](ExactHit& h) { h.crossings[0].free = true; }));
  EXPECT_TRUE(changed([](ExactHit& h) { h.crossings[0].part = 1; }));
  EXPECT_TRUE(changed([](ExactHit& h) { h.crossings[0].position.y = 1; }));
  EXPECT_TRUE(changed([](ExactHit& h) { h.crossings[0].normal.z = 1; }));
}

}  // namespace plumb

#include "conformance/envelopes/textbook/formulas.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "conformance/envelopes/textbook/hierarchy.h"
#include "conformance/envelopes/textbook/matrix.h"
#include "conformance/envelopes/textbook/shading.h"
#include "conformance/envelopes/textbook/solids.h"

namespace plumb::textbook {
namespace {

using Double = Arithmetic<double, false>;
using V = Vector<Double>;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Coordinates of a few units, so that roundings are some 1e-16; the formulas lose half of the digits near tangents at
/// most, which random rays come no nearer than 1e-5 to.
constexpr double kRounding = 1e-9;

class Random {
 public:
  explicit Random(unsigned seed) : bits_(seed) {}
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(bits_); }
  V vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  Ray<Double> ray() { return {vector(3), vector(1), 1e-6, kInfinity}; }

 private:
  std::mt19937_64 bits_;
};

Solid<Double> solid_of(Shape shape) {
  return {.shape = shape,
          .center = {0.3, -0.2, 0.4},
          .radius = 0.9,
          .half_height = 0.8,
          .tip_z = 0.7,
          .min = {-0.8, -0.6, -1},
          .max = {0.9, 0.7, 0.5}};
}

TEST(TextbookFormulas, SolidsAreTheSameByBoth) {
  Random random(3);
  int hits = 0, faces = 0, rays = 0;
  for (const Shape shape : {Shape::sphere, Shape::cylinder, Shape::cone}) {
    for (int i = 0; i < 20000; ++i, ++rays) {
      const Ray<Double> ray = random.ray();
      const auto usual = meet_solid(solid_of(shape), ray, Formulas::usual);
      const auto other = meet_solid(solid_of(shape), ray, Formulas::other);
      ASSERT_EQ(usual.has_value(), other.has_value()) << i;
      if (!usual) continue;
      EXPECT_NEAR(usual->t, other->t, kRounding * (1 + usual->t)) << i;
      EXPECT_EQ(usual->face, other->face) << i;
      ++hits;
      faces += usual->face != kSide;
    }
  }
  EXPECT_EQ(rays, 60000);
  EXPECT_GT(hits, 5000);
  EXPECT_GT(faces, 1000);
}

TEST(TextbookFormulas, HitsLieOnTheSurfaceAndSnappingKeepsThemThere) {
  Random random(5);
  int hits = 0;
  for (const Shape shape : {Shape::sphere, Shape::box, Shape::cylinder, Shape::cone}) {
    const Solid<Double> solid = solid_of(shape);
    for (int i = 0; i < 5000; ++i) {
      const Ray<Double> ray = random.ray();
      const auto at = meet_solid(solid, ray, Formulas::usual);
      if (!at) continue;
      ++hits;
      const V p = ray.at(at->t), q = snapped(solid, p, at->face), moved = p - q;
      EXPECT_LT(dot(moved, moved), kRounding * kRounding) << i;
      // A step along the normal leaves the solid: a ray back from there hits at once.
      const V out = unit(solid_normal(solid, ray, *at));
      const auto back = meet_solid(solid, {q + 1e-4 * out, -out, 0, 1}, Formulas::usual);
      if (std::fabs(std::fabs(q.z - solid.center.z) - solid.half_height) < 1e-3) continue;  // a rim
      ASSERT_TRUE(back) << i;
      EXPECT_NEAR(back->t, 1e-4, 1e-6) << i;  // the sides bend by (1e-4)^2
    }
  }
  EXPECT_GT(hits, 2000);
}

TEST(TextbookFormulas, TrianglesAreTheSameByBoth) {
  Random random(7);
  int hits = 0, misses = 0;
  for (int i = 0; i < 50000; ++i) {
    const V a = random.vector(1), b = random.vector(1), c = random.vector(1);
    Ray<Double> ray = random.ray();
    ray.direction = random.vector(1) - ray.origin;  // towards where triangles are
    const auto usual = meet_triangle(a, b, c, ray, Formulas::usual);
    const auto other = meet_triangle(a, b, c, ray, Formulas::other);
    ASSERT_EQ(usual.has_value(), other.has_value()) << i;
    if (!usual) {
      ++misses;
      continue;
    }
    ++hits;
    const V gap = ray.at(usual->t) - (a + usual->u * (b - a) + usual->v * (c - a));
    EXPECT_LT(dot(gap, gap), kRounding * kRounding) << i;
    EXPECT_NEAR(usual->t, other->t, kRounding * (1 + usual->t)) << i;
    EXPECT_NEAR(usual->u, other->u, 1e-7) << i;  // thin triangles lose two digits more
    EXPECT_NEAR(usual->v, other->v, 1e-7) << i;
  }
  EXPECT_GT(hits, 500);
  EXPECT_GT(misses, 10000);
}

TEST(TextbookFormulas, ReflectanceIsTheSameByBoth) {
  int compared = 0;
  for (const double index : {1.1, 1.5, 2.4}) {
    for (int i = 1; i <= 100; ++i) {
      for (const bool inside : {false, true}) {
        const Interface<Double> at{i / 100.0, inside ? index : 1, inside ? 1 : index};
        const auto beyond = at.cosine_beyond();
        if (!beyond) continue;
        const double usual = reflectance(at, *beyond, false, Formulas::usual);
        EXPECT_NEAR(usual, reflectance(at, *beyond, false, Formulas::other), 1e-13);
        EXPECT_GE(usual, 0);
        EXPECT_LE(usual, 1);
        ++compared;
      }
    }
    // Head on: ((n - 1) / (n + 1))^2.
    const double head_on = (index - 1) / (index + 1) * ((index - 1) / (index + 1));
    EXPECT_NEAR(reflectance<Double>({1, 1, index}, 1, false, Formulas::usual), head_on, 1e-15);
    EXPECT_NEAR(reflectance<Double>({1, 1, index}, 1, true, Formulas::usual), head_on, 1e-15);
  }
  EXPECT_GT(compared, 350);
  EXPECT_FALSE((Interface<Double>{0.5, 1.5, 1}.cosine_beyond())) << "beyond the critical angle";
}

TEST(TextbookFormulas, InverseUndoesAMatrix) {
  Random random(9);
  int cases = 0;
  for (int i = 0; i < 1000; ++i) {
    Matrix<Double> m = Matrix<Double>::translation(random.vector(5));
    for (std::size_t axis = 0; axis < 3; ++axis) m = m * Matrix<Double>::rotation(axis, random.number(-180, 180));
    m = m * Matrix<Double>::scaling({random.number(0.1, 3), -random.number(0.1, 3), random.number(0.1, 3)});
    const V p = random.vector(2), back = m.inverse().move(m.move(p)) - p;
    EXPECT_LT(dot(back, back), 1e-24) << i;  // 5 units of coordinates, through factors of at most 30
    ++cases;
  }
  EXPECT_EQ(cases, 1000);
  EXPECT_EQ((Matrix<Double>::rotation(2, 90).move({1, 0, 0}).y), 1) << "counter-clockwise";
  EXPECT_EQ((Matrix<Double>::rotation(0, 90).move({0, 1, 0}).z), 1);
  EXPECT_EQ((Matrix<Double>::rotation(1, 90).move({0, 0, 1}).x), 1);
}

TEST(TextbookHierarchy, OffersEveryBoxThatARayMeets) {
  Random random(11);
  std::vector<Bounds<Double>> boxes(500);
  for (auto& box : boxes) {
    const V center = random.vector(3);
    box.extend(center), box.extend(center + random.vector(1));
  }
  const Hierarchy<Double> hierarchy(boxes);
  std::size_t met = 0, offered = 0;
  for (int i = 0; i < 5000; ++i) {
    Ray<Double> ray = random.ray();
    if (i % 4 == 0) ray.direction = {0, 0, i % 8 == 0 ? 1.0 : -1.0};
    std::vector<bool> seen(boxes.size());
    hierarchy.walk(ray, [&](std::uint32_t box) {
      seen[box] = true;
      ++offered;
      return false;
    });
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      if (boxes[k].entry(ray) == kInfinity) continue;
      EXPECT_TRUE(seen[k]) << i;
      ++met;
    }
  }
  EXPECT_GT(met, 4000u);
  EXPECT_LT(offered, 5000 * boxes.size() / 10) << "not all of them";
  EXPECT_FALSE(Hierarchy<Double>().walk(random.ray(), [](std::uint32_t) { return true; }));
}

}  // namespace
}  // namespace plumb::textbook

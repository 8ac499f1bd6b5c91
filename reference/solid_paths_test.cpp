#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "reference/algebraic_t.h"
#include "reference/solid_cases_for_tests.h"
#include "reference/solid_hit.h"

namespace plumb {
namespace {

struct Tally {
  int cases = 0, hits = 0, free = 0, misses = 0, inside = 0, at_end = 0, most = 0;
};

ExactHit compare_paths(const PlacedShape& placed, const Ray& ray, StageCounters& counters) {
  StageCounters uncounted;
  const ExactHit filtered = solid_hit(placed, ray, ExactPath::filtered, counters);
  const ExactHit polynomial = solid_hit(placed, ray, ExactPath::polynomial, uncounted);
  const ExactHit rational = solid_hit(placed, ray, ExactPath::rational, uncounted);
  EXPECT_EQ(difference(polynomial, rational), "") << describe(placed, ray);
  EXPECT_EQ(difference(filtered, polynomial), "") << describe(placed, ray);
  return filtered;
}

void count(const ExactHit& hit, Tally& tally) {
  ++tally.cases;
  tally.hits += hit.hit_class == HitClass::hit;
  tally.free += hit.hit_class == HitClass::boundary || hit.hit_class == HitClass::tangent;
  tally.misses += hit.hit_class == HitClass::miss;
  tally.inside += hit.inside;
  tally.most = std::max(tally.most, static_cast<int>(hit.crossings.size()));
  for (const ExactCrossing& c : hit.crossings) tally.at_end += c.place != RangePlace::within;
}

/// The same line with its range cut at the first or last t that it reported: on the root or within a spacing of it.
Ray cut(const Ray& ray, const ExactHit& hit, int turn) {
  Ray shorter = ray;
  if (hit.crossings.empty()) return ray;
  const bool first = turn % 2 == 0;
  const double t = first ? hit.crossings.front().t_double : hit.crossings.back().t_double;
  (turn % 4 < 2 ? shorter.t_min : shorter.t_max) = t;
  return shorter;
}

/// PLUMB_SOLID_CASES multiplies the number of cases, for long runs by hand.
int scale() {
  const char* factor = std::getenv("PLUMB_SOLID_CASES");
  return factor != nullptr ? std::atoi(factor) : 1;
}

void run(ShapeKind kind, int each, Tally& tally) {
  for (const SolidFamily& family : solid_families(kind)) {
    std::mt19937_64 random(20240601);
    std::uint64_t filter = 0, all = 0;
    for (const NamedMatrix& m : placements()) {
      StageCounters counters;
      for (int i = 0; i < each * scale(); ++i) {
        const SolidCase c = family.make(random);
        const PlacedShape placed = place(c, m.matrix);
        const Ray ray = world_ray(c, m.matrix);
        const ExactHit hit = compare_paths(placed, ray, counters);
        if (i % 4 == 0) count(compare_paths(placed, cut(ray, hit, i / 4), counters), tally);
        count(hit, tally);
        if (::testing::Test::HasFailure()) FAIL() << family.name << ", " << m.name << ", case " << i;
      }
      filter += counters.filter;
      all += counters.filter + counters.expansion;
    }
    std::printf("%-14s undecided by the filter: %5.1f %% of %llu\n", family.name,
                100.0 * static_cast<double>(all - filter) / static_cast<double>(all),
                static_cast<unsigned long long>(all));
  }
}

TEST(SolidPaths, SphereAgrees) {
  Tally tally;
  run(ShapeKind::sphere, 60, tally);
  EXPECT_EQ(tally.cases, 6 * 7 * 75 * scale());
  EXPECT_GT(tally.hits, 500);
  EXPECT_GT(tally.free, 50);
  EXPECT_GT(tally.misses, 300);
  EXPECT_GT(tally.inside, 70);
  EXPECT_GT(tally.at_end, 50);
  EXPECT_EQ(tally.most, 2);
}

TEST(SolidPaths, BoxAgrees) {
  Tally tally;
  run(ShapeKind::box, 60, tally);
  EXPECT_EQ(tally.cases, 5 * 7 * 75 * scale());
  EXPECT_GT(tally.hits, 500);
  EXPECT_GT(tally.free, 150);
  EXPECT_GT(tally.misses, 300);
  EXPECT_GT(tally.inside, 70);
  EXPECT_GT(tally.at_end, 100);
  EXPECT_EQ(tally.most, 2);
}

TEST(SolidPaths, CylinderAgrees) {
  Tally tally;
  run(ShapeKind::cylinder, 60, tally);
  EXPECT_EQ(tally.cases, 6 * 7 * 75 * scale());
  EXPECT_GT(tally.hits, 500);
  EXPECT_GT(tally.free, 150);
  EXPECT_GT(tally.misses, 300);
  EXPECT_GT(tally.inside, 70);
  EXPECT_GT(tally.at_end, 100);
  EXPECT_EQ(tally.most, 2);
}

TEST(SolidPaths, ConeAgrees) {
  Tally tally;
  run(ShapeKind::cone, 60, tally);
  EXPECT_EQ(tally.cases, 7 * 7 * 75 * scale());
  EXPECT_GT(tally.hits, 500);
  EXPECT_GT(tally.free, 150);
  EXPECT_GT(tally.misses, 300);
  EXPECT_GT(tally.inside, 70);
  EXPECT_GT(tally.at_end, 100);
  EXPECT_EQ(tally.most, 4);
}

TEST(SolidPaths, AgreeFarOutsideOfTheFiltersRange) {
  // Lengths of 2^+-480 in the shape or in the matrix: the coefficients leave the range of doubles.
  int hits = 0;
  for (const ShapeKind kind : {ShapeKind::sphere, ShapeKind::box, ShapeKind::cylinder, ShapeKind::cone}) {
    for (const SolidFamily& family : solid_families(kind)) {
      std::mt19937_64 random(77);
      for (int i = 0; i < 12; ++i) {
        SolidCase c = family.make(random);
        const double size = i % 2 == 0 ? 0x1p480 : 0x1p-480;
        const AffineMatrix matrix = placements()[static_cast<std::size_t>(i) % 7].matrix * scaling({size, size, size});
        Ray ray = world_ray(c, matrix);
        if (i % 3 == 0) ray.direction = 0x1p-300 * ray.direction;
        if (i % 3 == 1) ray.direction = 0x1p300 * ray.direction;
        StageCounters counters;
        const ExactHit hit = compare_paths(place(c, matrix), ray, counters);
        ASSERT_FALSE(HasFailure()) << family.name << ", case " << i;
        hits += !hit.crossings.empty();
      }
    }
  }
  EXPECT_GT(hits, 120);
}

}  // namespace
}  // namespace plumb

#include "tools/developer/exact_hits.h"

#include <gtest/gtest.h>

namespace plumb {
namespace {

constexpr plumb_precision kPrecisions[] = {PLUMB_FLOAT, PLUMB_DOUBLE};
constexpr Placing kPlacings[] = {Placing::as_given, Placing::placed};
constexpr Accel kAccels[] = {Accel::linear, Accel::bvh2, Accel::bvh8};

struct Sum {
  std::int64_t rays = 0, hits = 0, boundary = 0, ranges = 0, wrong_if_rounded = 0;
};

void expect_exact(const ExactHits& found, Sum& sum) {
  EXPECT_EQ(found.wrong(), 0) << found.source << ": " << found.first;
  EXPECT_EQ(found.unsupported, 0) << found.source;
  EXPECT_LT(found.largest_t_error, 1) << found.source;
  sum.rays += found.rays;
  sum.hits += found.hits;
  sum.boundary += found.boundary;
  sum.ranges += found.range_questions;
  sum.wrong_if_rounded += found.wrong_if_rounded;
}

TEST(ExactHits, TrianglesOfEveryFamilyHaveTheExactClass) {
  Sum sum, placed;
  int families = 0;
  for (const FamilyKind* family : family_kinds()) {
    if (!family->id.starts_with('T')) continue;
    ++families;
    const std::int64_t count = family->id == "T12" ? 120 : 1200;
    for (const plumb_precision precision : kPrecisions) {
      for (const Accel accel : kAccels) {
        expect_exact(exact_hits_of(*family, precision, Placing::as_given, accel, count), sum);
        expect_exact(exact_hits_of(*family, precision, Placing::placed, accel, count), placed);
      }
    }
  }
  EXPECT_EQ(families, 13);
  EXPECT_GE(sum.rays, 58'000);
  EXPECT_GE(sum.hits, 20'000);
  EXPECT_GE(sum.boundary, 5'000);
  EXPECT_GE(sum.ranges, 20'000);
  EXPECT_GE(placed.rays, 58'000);
  EXPECT_GE(placed.hits, 15'000);
  EXPECT_GE(placed.ranges, 15'000);
  EXPECT_GE(placed.wrong_if_rounded, 1'000) << "the rounded ray of the object's frame gets them wrong";
}

TEST(ExactHits, NothingLeavesAClosedMesh) {
  Sum sum;
  for (const plumb_precision precision : kPrecisions)
    for (const Placing placing : kPlacings)
      for (const Accel accel : kAccels) expect_exact(exact_hits_in_closed_meshes(precision, placing, accel, 600), sum);
  EXPECT_GE(sum.rays, 4'700);
  EXPECT_GE(sum.hits, 4'600);
  EXPECT_GE(sum.boundary, 500);
}

TEST(ExactHits, CoincidentTrianglesAreOrderedByTheExactT) {
  Sum sum;
  for (const plumb_precision precision : kPrecisions)
    for (const Placing placing : kPlacings)
      for (const Accel accel : kAccels) expect_exact(exact_hits_among_ties(precision, placing, accel, 3000), sum);
  EXPECT_GE(sum.rays, 24'000);
  EXPECT_GE(sum.hits, 10'000);
  EXPECT_GE(sum.wrong_if_rounded, 1'000) << "the order of the rounded t gets them wrong";
}

}  // namespace
}  // namespace plumb

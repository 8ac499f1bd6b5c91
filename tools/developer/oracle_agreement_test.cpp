#include "tools/developer/oracle_agreement.h"

#include <gtest/gtest.h>

namespace plumb {
namespace {

void expect_agreement(const OracleAgreement& agreement, std::int64_t count) {
  EXPECT_GE(agreement.cases, count) << agreement.family;
  EXPECT_EQ(agreement.disagreements, 0) << agreement.family << ": " << agreement.first;
  testing::Test::RecordProperty(agreement.family + "_undecided", static_cast<int>(agreement.undecided));
}

TEST(OracleAgreement, OnTheRaysOfEveryFamily) {
  std::size_t families = 0;
  for (const FamilyKind* family : family_kinds()) {
    const std::int64_t count = family->id == "T12" ? 24 : 240;
    expect_agreement(agree_on_rays(*family, count), count);
    ++families;
  }
  EXPECT_GE(families, 30U);
}

TEST(OracleAgreement, OnBoxes) {
  for (const char* id : {"A1", "B2", "C2", "M1", "S2", "T7"})
    expect_agreement(agree_on_boxes(family_kind(id), 200), 200);
}

TEST(OracleAgreement, OnRotationsAndReflectances) {
  expect_agreement(agree_on_rotations(200), 200);
  expect_agreement(agree_on_fresnel(500), 500);
}

TEST(OracleAgreement, OrdinaryRaysAreDecidedByTheFilter) {
  EXPECT_LE(agree_on_rays(family_kind("T0"), 1200).undecided, 0);
  EXPECT_LE(agree_on_rays(family_kind("S0"), 1200).undecided, 12);
}

}  // namespace
}  // namespace plumb

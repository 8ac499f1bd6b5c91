// What the growth gate measured, and its error rates, from figures made by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/calibration_text.h"
#include "reports/growth_text.h"

namespace plumb {
namespace {

using testing::HasSubstr;
using testing::Not;

GrowthFigures linear() {
  GrowthFigures f;
  f.trace = GrowthDecision::fail, f.build = GrowthDecision::pass;
  f.views = {{"oblique", {{1000, 1e-6}, {64'000, 64e-6}}, {1, 0.9, 1.1}},
             {"axis-aligned", {{1000, 1e-6}, {64'000, 32e-6}}, {0.8, 0.7, 0.9}}};
  f.building = {"build", {{1000, 0.01}, {64'000, 0.5}, {256'000, 2}}, {1, 0.9, 1.1}};
  f.rounds = 2, f.attempts = 1, f.runs = 40, f.seed = 7;
  f.notes = {"a note"};
  return f;
}

TEST(GrowthText, SaysWhatTheFiguresMean) {
  const std::string text = growth_text(linear());
  EXPECT_THAT(text, HasSubstr("64.000"));
  EXPECT_THAT(text, HasSubstr("1.00  (between 0.90 and 1.10)"));
  EXPECT_THAT(text, HasSubstr("trace: fail (pass below 0.5, fail above 0.6)   build: pass (fail above 1.5)"));
  EXPECT_THAT(text, HasSubstr("a ray takes 4.0 times as long (oblique view), and building 4.0 times as long"));
  // 640 x 480 rays of a millisecond, at a million triangles.
  EXPECT_THAT(text, HasSubstr("would take about 3.1e+02 s"));
  EXPECT_THAT(text, HasSubstr("a note\n"));
  EXPECT_THAT(growth_text({}), HasSubstr("0 runs in 0 rounds"));
}

TEST(GrowthPlot, DrawsEachViewAndTheLimits) {
  const ReportFile file = growth_plot(linear());
  EXPECT_EQ(file.name, "growth.gnuplot");
  EXPECT_THAT(file.text, HasSubstr("oblique: slope 1.00"));
  EXPECT_THAT(file.text, HasSubstr("64000 64 \"\""));
  EXPECT_THAT(file.text, HasSubstr("the limit: slope 0.5"));
  EXPECT_THAT(growth_plot({}).text, HasSubstr("plot 1/0"));
}

TEST(CalibrationText, CountsWrongAndUndecidedApart) {
  std::vector<CalibrationDecision> all;
  for (int i = 0; i < 6; ++i) {
    CalibrationDecision d;
    d.subject = "linear", d.gate = "mesh-trace", d.loaded = i % 2 == 1, d.seconds = 10 + i;
    d.expected = GrowthDecision::fail;
    d.found = i == 3 ? GrowthDecision::pass : i == 4 ? GrowthDecision::undecided : GrowthDecision::fail;
    all.push_back(d);
  }
  const std::string text = calibration_text(all);
  EXPECT_THAT(text, HasSubstr("| linear | mesh-trace | fail | 3 / 0 / 1 | 3 / 1 / 0 |"));
  EXPECT_THAT(text, HasSubstr("6 decisions, 1 wrong, 1 undecided (16.7 %); median time of a gate 13.0 s"));
  EXPECT_THAT(text, HasSubstr("false passes, under load: 1 of 3"));
  EXPECT_THAT(text, HasSubstr("false fails, alone: 0 of 0 (<= 100.0 % at 95 %)"));
  EXPECT_THAT(calibration_text({}), HasSubstr("0 decisions"));
}

TEST(UpperRate, IsThatOfClopperAndPearson) {
  // None of n: 1 - 0.05^(1/n).
  EXPECT_NEAR(upper_rate(0, 200), 0.014867, 1e-6);
  EXPECT_NEAR(upper_rate(0, 1), 0.95, 1e-9);
  // 1 of 20: the p for which (1-p)^20 + 20 p (1-p)^19 = 0.05.
  const double p = upper_rate(1, 20);
  EXPECT_NEAR(std::pow(1 - p, 20) + 20 * p * std::pow(1 - p, 19), 0.05, 1e-9);
  EXPECT_EQ(upper_rate(3, 3), 1);
}

}  // namespace
}  // namespace plumb

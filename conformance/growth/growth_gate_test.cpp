#include "conformance/growth/growth_gate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "conformance/growth/simulated_program.h"

namespace plumb {
namespace {

const std::vector<double> kSizes{1200, 4800, 19200, 76800, 307200};

double logarithmic(double n) { return 1e-7 * std::log2(n); }
double by_search_tree(double n) { return 3e-7 + 4e-8 * std::log2(n) + 2e-12 * n; }
double linear(double n) { return 5e-9 * n; }

struct Known {
  std::string name;
  SimulatedProgram program;
  GrowthDecision trace, build;
};

/// Programs of known growth, as they come.
std::vector<Known> known_programs() {
  const auto same = [](double (*ray)(double)) {
    SimulatedProgram program;
    program.oblique_ray = program.axis_aligned_ray = ray;
    return program;
  };
  std::vector<Known> all;
  const auto add = [&](const std::string& name, const SimulatedProgram& program, GrowthDecision trace,
                       GrowthDecision build) {
    all.push_back({name, program, trace, build});
  };
  using enum GrowthDecision;
  add("logarithmic", same(logarithmic), pass, pass);
  add("with cache misses", same(by_search_tree), pass, pass);
  add("cube root", same([](double n) { return 4e-8 * std::cbrt(n); }), pass, pass);
  add("linear", same(linear), fail, pass);
  add("linear with a tiny constant", same([](double n) { return 3e-7 + 3e-10 * n; }), fail, pass);
  SimulatedProgram one = same(logarithmic);
  one.axis_aligned_ray = [](double n) { return 1e-6 + linear(n) / 15; };
  add("linear along axes only", one, fail, pass);
  one = same(logarithmic);
  one.start = 1;
  add("slow start", one, pass, pass);
  one.start = 0.4, one.warm_up = 1, one.warm_rays = 50'000;
  add("compiled just in time", one, pass, pass);
  one.oblique_ray = one.axis_aligned_ray = [](double n) { return 2e-8 * n; };
  add("compiled just in time, linear", one, fail, pass);
  one = same(logarithmic);
  one.build = [](double n) { return 1e-10 * n * n; };
  add("quadratic build", one, pass, fail);
  one.build = [](double n) { return 1e-9 * n * n; };
  add("quadratic build, past the limit", one, pass, fail);
  one.build = [](double n) { return 3e-7 * n * std::log2(n); };
  add("n log n build", one, pass, pass);
  return all;
}

/// Decisions of each program under one kind of noise: wrong ones, undecided ones.
struct Tally {
  int decisions = 0, wrong = 0, undecided = 0;
  std::string which;
};
Tally tally(double noise, unsigned outliers, int repeats) {
  Tally t;
  for (Known known : known_programs()) {
    known.program.noise = noise, known.program.outliers = outliers;
    for (int i = 0; i < repeats; ++i) {
      SCOPED_TRACE(known.name + " " + std::to_string(i + 1));
      const auto seed = static_cast<std::uint64_t>(1 + i);
      const GrowthSettings settings{.sizes = kSizes, .seed = seed};
      const GrowthFigures figures = run_growth_gate(settings, asked(known.program, kSizes, seed));
      for (const auto& [found, right] :
           {std::pair{figures.trace, known.trace}, std::pair{figures.build, known.build}}) {
        ++t.decisions;
        if (found == GrowthDecision::undecided)
          ++t.undecided;
        else if (found != right)
          ++t.wrong;
        if (found != right) t.which += known.name + " (seed " + std::to_string(seed) + "), ";
      }
    }
  }
  return t;
}

TEST(GrowthGate, DecidesKnownProgramsOnAQuietMachine) {
  const Tally t = tally(0.03, 0, 10);
  EXPECT_EQ(t.decisions, 240);
  EXPECT_EQ(t.wrong, 0) << t.which;
  EXPECT_EQ(t.undecided, 0) << t.which;
}

TEST(GrowthGate, DecidesKnownProgramsOnABusyMachine) {
  const Tally t = tally(0.12, 30, 10);
  EXPECT_EQ(t.decisions, 240);
  EXPECT_EQ(t.wrong, 0) << t.which;
  EXPECT_LE(t.undecided, 12) << t.which;
}

TEST(GrowthGate, IsUndecidedRatherThanWrongWhereNothingCanBeTold) {
  const Tally t = tally(0.6, 8, 6);
  EXPECT_EQ(t.decisions, 144);
  EXPECT_EQ(t.wrong, 0) << t.which;
  EXPECT_GT(t.undecided, 12);
}

TEST(GrowthGate, NeverAsksForAPictureHigherThanFormatsHold) {
  // Its warm-up is paid in the oblique view alone, so that the strip never seems to take anything.
  SimulatedProgram program;
  program.oblique_ray = logarithmic;
  program.axis_aligned_ray = [](double) { return 1e-10; };
  program.start = 1.4;
  int largest = 0, strips = 0;
  const GrowthAsk ask = asked(program, kSizes, 1);
  const GrowthFigures figures = run_growth_gate({.sizes = kSizes, .seed = 1}, [&](const GrowthQuestion& q) {
    largest = std::max({largest, q.width, q.height});
    const bool is_strip = q.view == GrowthView::axis_aligned;
    strips += is_strip;
    GrowthAnswer answer = ask(q);
    if (is_strip) answer.cpu_seconds -= 1;
    return answer;
  });
  EXPECT_GE(strips, 5);
  EXPECT_GT(figures.runs, 20);
  EXPECT_GE(largest, 20'000) << "it was tried";
  EXPECT_LE(largest, 32'768);
}

}  // namespace
}  // namespace plumb

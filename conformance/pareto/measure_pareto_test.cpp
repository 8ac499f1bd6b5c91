#include "conformance/pareto/measure_pareto.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "conformance/pareto/contender.h"
#include "conformance/pareto/picture_figures.h"
#include "conformance/pareto/speed_figures.h"
#include "conformance/pareto/tolerant_kernel.h"
#include "conformance/subject/shipped_kernels.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

TEST(Rate, OfNoneHasTheBoundOfThree) {
  EXPECT_EQ((Rate{0, 100'000}).per_million(), 0);
  EXPECT_EQ((Rate{0, 100'000}).bound_per_million(), 30);
  EXPECT_EQ((Rate{5, 1000}).per_million(), 5000);
  EXPECT_EQ((Rate{0, 0}).bound_per_million(), 0);
}

TEST(SelectedKernels, TakesGlobsAndAlwaysTheOne) {
  const std::vector<std::string> names{"cgal", "embree", "mt-double", "mt-float"};
  EXPECT_EQ(selected_kernels(names, "", "mt-double"), names);
  EXPECT_EQ(selected_kernels(names, "emb*", "mt-double"), (std::vector<std::string>{"embree", "mt-double"}));
  EXPECT_EQ(selected_kernels(names, "cgal,mt-float", "plumb"), (std::vector<std::string>{"cgal", "mt-float"}));
  EXPECT_THROW(selected_kernels(names, "cgal,embre", "mt-double"), InputError);
}

TEST(ShippedContenders, StandInAnOrderAndKernelsOfDoublesTwice) {
  const std::vector<Contender> contenders =
      shipped_contenders({"empty", "mt-double", "mt-float", "sphere-precise-float"}, PLUMB_MESHES, 0);
  ASSERT_EQ(contenders.size(), 3u);
  EXPECT_EQ(contenders[0].name, "mt-float");
  EXPECT_EQ(contenders[1].name, "mt-double");
  EXPECT_EQ(contenders[1].inputs, PLUMB_FLOAT);
  EXPECT_EQ(contenders[2].name, "mt-double/53");
  EXPECT_EQ(contenders[2].inputs, PLUMB_DOUBLE);
}

TEST(Contender, KeepsWhatASubjectDidWrong) {
  Contender contender{"it", PLUMB_FLOAT, nullptr, {}};
  EXPECT_TRUE(contender.attempt("a", [] {}));
  EXPECT_FALSE(contender.attempt("b", [] { throw SubjectFailure(Verdict::crash, "signal", "died"); }));
  EXPECT_FALSE(contender.attempt("c", [] { throw UnsupportedBySubject("will not"); }));
  EXPECT_EQ(contender.failures, (std::vector<std::string>{"it: b: crash: died", "it: c: will not"}));
}

TEST(DropNotFinite, TurnsSuchHitsIntoMissesAndNoOthers) {
  const double infinity = std::numeric_limits<double>::infinity();
  RawHits hits;
  hits.surface = {0, 0, SubjectHit::kMiss, 0, 0, kUnwrittenIndex};
  hits.primitive = {0, 0, 0, 0, 0, 0};
  hits.t = {1, infinity, infinity, -infinity, kUnwrittenNumber, infinity};
  hits.u = hits.v = {0, 0, 0, 0, 0, 0};
  EXPECT_EQ(drop_not_finite(hits), 2);
  EXPECT_EQ(hits.surface, (std::vector<std::uint32_t>{0, SubjectHit::kMiss, SubjectHit::kMiss, SubjectHit::kMiss, 0,
                                                      kUnwrittenIndex}));
}

TEST(SpeedFigure, IsTheMedianWithItsSpread) {
  const SpeedFigure odd = speed_figure(1000, {3, 1, 9, 2, 4});
  EXPECT_EQ(odd.million_rays_a_second, 3);
  EXPECT_EQ(odd.slowest, 1);
  EXPECT_EQ(odd.fastest, 9);
  EXPECT_EQ(odd.rounds, 5);
  EXPECT_EQ(speed_figure(1000, {1, 2, 4, 8}).million_rays_a_second, 3);
  EXPECT_EQ(speed_figure(1000, {}).rounds, 0);
}

TEST(SpeedRays, AreRepresentableAndTheLongerListBeginsWithTheShorter) {
  const Rounding rounded(PLUMB_FLOAT);
  const std::vector<Ray> few = speed_rays(1, 10, rounded), many = speed_rays(1, 100, rounded);
  for (std::size_t i = 0; i < few.size(); ++i) {
    EXPECT_EQ(few[i].origin, many[i].origin);
    EXPECT_EQ(few[i].direction, rounded(many[i].direction));
  }
}

TEST(ColorDistance, IsOverPixelsAndChannels) {
  Image a(2, 1), b(2, 1);
  b.at(1, 0) = {0.5, 0, -1};
  const ColorDistance distance = color_distance(a, b);
  EXPECT_EQ(distance.largest, 1);
  EXPECT_DOUBLE_EQ(distance.rms, std::sqrt(1.25 / 6));
}

TEST(PictureFigures, MoreSamplesAreNearerToTheConvergedPicture) {
  const auto figures =
      picture_figures(PLUMB_SOURCE_DIR "/scenes/library/antialiasing.xml",
                      {.width = 24, .height = 18, .samples = {1, 16}, .reference_samples = 64}, [](double) {});
  ASSERT_EQ(figures.size(), 2u);
  EXPECT_EQ(figures[0].scene, "antialiasing");
  EXPECT_EQ(figures[0].samples, 1);
  EXPECT_GT(figures[0].rms, figures[1].rms);
  EXPECT_GT(figures[1].rms, 0);
  EXPECT_GT(figures[1].cpu_seconds, 0);
}

/// Everything but times.
std::vector<std::int64_t> counts_of(const ParetoResults& results) {
  std::vector<std::int64_t> counts;
  for (const std::vector<ParetoKernel>* list : {&results.triangles, &results.spheres}) {
    for (const ParetoKernel& kernel : *list) {
      for (const ClassFigure& f : kernel.classes)
        counts.insert(counts.end(), {f.rays, f.false_misses, f.false_hits, f.wrong_crossings, f.not_finite});
      for (const EscapeFigure& f : kernel.escapes) counts.insert(counts.end(), {f.rays, f.escapes});
      for (const ClosestFigure& f : kernel.closest)
        counts.insert(counts.end(), {f.rays, f.missed, f.beside, f.behind, f.ties});
    }
  }
  return counts;
}

TEST(MeasurePareto, AsksAllTheSameAndTheSameAgain) {
  ParetoPlan plan;
  plan.kernels = {"mt-double", "mt-float", "sphere-precise-float"};
  plan.intensity = 0.002;
  int told = 0;
  plan.progress = [&](const std::string&, double share) { told += share >= 0 && share <= 1.2; };
  const ParetoResults results = measure_pareto(plan);
  EXPECT_GT(told, 0);
  EXPECT_TRUE(results.notes.empty());
  ASSERT_EQ(results.triangles.size(), 3u);
  ASSERT_EQ(results.spheres.size(), 1u);
  for (const ParetoKernel& kernel : results.triangles) {
    EXPECT_EQ(kernel.classes.size(), 8u);
    EXPECT_EQ(kernel.escapes.size(), 3u);
    EXPECT_EQ(kernel.closest.size(), 6u);
    EXPECT_GE(kernel.speed.rounds, 5);
    EXPECT_GT(kernel.speed.million_rays_a_second, 0);
    for (const ClassFigure& figure : kernel.classes) EXPECT_GE(figure.rays, 200);
    EXPECT_EQ(kernel.classes[0].wrong().count, 0) << "control";
  }
  EXPECT_GT(results.triangles[0].classes[1].wrong().count, 0) << "a float kernel at edges";
  EXPECT_GT(results.triangles[0].escapes[0].escapes, 0);
  EXPECT_EQ(results.spheres[0].classes.size(), 7u);
  EXPECT_EQ(counts_of(measure_pareto(plan)), counts_of(results));
}

}  // namespace
}  // namespace plumb

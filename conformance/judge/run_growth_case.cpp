#include "conformance/judge/run_growth_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "conformance/judge/growth_runs.h"
#include "conformance/judge/stop_verdict.h"
#include "renderer/image/staged_file.h"

namespace plumb {
namespace {

/// What nobody can know before.
std::uint64_t random_seed() {
  std::random_device device;
  return (std::uint64_t{device()} << 32 | device()) >> 1;
}

CheckResult undecided() {
  return stopped(Verdict::internal_error, "undecided", "the times do not show for certain how they grow",
                 "a person has to look at this case; it costs no points");
}

CheckResult passed(const std::string& summary) { return stopped(Verdict::pass, "", summary, ""); }

/// No measured number stands in a result; they are with the usage.
CheckResult trace_result(const GrowthFigures& figures) {
  switch (figures.trace) {
    case GrowthDecision::undecided:
      return undecided();
    case GrowthDecision::pass:
      return passed("the time a ray takes grows far slower than the number of " + figures.of);
    case GrowthDecision::fail:
      break;
  }
  const bool along_axes_only = figures.views.size() > 1 && figures.views[0].slope.high < 0.5;
  if (along_axes_only)
    return stopped(
        Verdict::fail, "not_sublinear",
        "the time that a ray along an axis takes grows with the number of " + figures.of,
        "a direction with a component of exactly 0 must not make the box test visit everything: see 0/0 and 0 * inf");
  return stopped(Verdict::fail, "not_sublinear",
                 "the time a ray takes grows about in proportion to the number of " + figures.of,
                 "a ray must visit few of them: build a hierarchy of boxes, and skip every box that the ray misses");
}

CheckResult build_result(const GrowthFigures& figures) {
  switch (figures.build) {
    case GrowthDecision::undecided:
      return undecided();
    case GrowthDecision::pass:
      return passed("the time to read and build does not grow much faster than the number of " + figures.of);
    case GrowthDecision::fail:
      break;
  }
  return stopped(Verdict::fail, "slow_build",
                 "the time to read and build grows much faster than the number of " + figures.of,
                 "look for a loop over everything within a loop over everything: in reading, in joining, in splitting");
}

}  // namespace

struct GrowthGates::Gate {
  GrowthScenes scenes;
  std::optional<GrowthFigures> figures;
  std::optional<CheckResult> stop;
  std::string log;
};

GrowthGates::GrowthGates(std::function<void(const std::string&)> progress) : progress_(std::move(progress)) {}
GrowthGates::~GrowthGates() = default;

void GrowthGates::judge(const SuiteCase& suite_case, const Runner& runner, Workspace& workspace, double seconds_left,
                        const ResultFolder& results, CaseResult& result) {
  if (runner.render.empty()) {
    result.check = stopped(Verdict::fail, "build", "submission.toml says nothing of how a picture is made",
                           "give render = [...] in its [runner]");
    return;
  }
  auto known = std::ranges::find_if(gates_, [&](const auto& gate) { return gate->scenes == suite_case.growth; });
  if (known == gates_.end()) {
    auto gate = std::make_unique<Gate>();
    gate->scenes = suite_case.growth;
    const std::uint64_t seed = suite_case.growth.seed.value_or(random_seed());
    GrowthRunner runs(suite_case, seed, runner, workspace);
    GrowthSettings settings;
    settings.sizes = runs.sizes();
    settings.of = suite_case.growth.object.empty() ? "triangles" : "objects";
    settings.budget_seconds = std::min(suite_case.growth.budget_seconds, seconds_left);
    settings.run_seconds = suite_case.cpu_seconds;
    settings.seed = seed;
    settings.progress = [&](const std::string& what) { progress_(suite_case.id + ": " + what); };
    try {
      gate->figures = run_growth_gate(settings, [&](const GrowthQuestion& question) { return runs.run(question); });
    } catch (const GrowthStop& stop) {
      gate->stop = stop.result();
    }
    gate->log = runs.log();
    gates_.push_back(std::move(gate));
    known = std::prev(gates_.end());
  }
  const Gate& gate = **known;
  result.growth = gate.figures;
  result.check = gate.stop                       ? *gate.stop
                 : suite_case.measure == "trace" ? trace_result(*gate.figures)
                                                 : build_result(*gate.figures);
  write_file_staged(results.case_folder(suite_case.id) / "log.txt", gate.log);
}

}  // namespace plumb

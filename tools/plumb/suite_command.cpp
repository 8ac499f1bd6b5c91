#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <random>
#include <stdexcept>

#include "conformance/judge/build_suite.h"
#include "conformance/sandbox/run_process.h"
#include "renderer/math/input_error.h"
#include "tools/plumb/command.h"
#include "tools/plumb/grading.h"
#include "tools/plumb/progress_bar.h"
#include "tools/plumb/shipped.h"
#include "tools/plumb/suite_score_command.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string suite;
  std::string out;
  int jitters = 0;
  std::optional<std::uint64_t> seed;
  std::string pictures;
  std::string mutants;
  bool without_fingerprints = false;
};

/// Drawn where none is given: nobody can prepare for the views.
std::uint64_t drawn_seed() {
  std::random_device device;
  return (std::uint64_t{device()} << 32 | device()) >> 1;
}

int build(const Arguments& a) {
  SuiteBuildRequest request;
  request.suite = a.suite;
  request.out = a.out;
  request.jitters = a.jitters;
  request.seed = a.seed ? *a.seed : drawn_seed();
  request.pictures = a.pictures;
  request.plumb_version = PLUMB_VERSION;
  if (!a.without_fingerprints && a.pictures.empty()) {
    request.mutants = a.mutants.empty() ? shipped_mutants() : fs::path(a.mutants);
    request.known_mistakes = shipped_known_mistakes();
    if (a.mutants.empty() && !has_shipped_mutants())
      throw InputError({request.mutants.string()},
                       "the programs with known mistakes are not there: build them by './dev mutants', or say "
                       "--without-fingerprints (no wrong picture is diagnosed then)");
  }
  stop_on_signals();
  ProgressBar bar("suite");
  request.progress = [&](const std::string&, double share) { bar.show(share); };
  BuiltSuite built;
  try {
    built = build_suite(request);
  } catch (const std::runtime_error&) {
    if (!interrupt_flag()) throw;
    return kInterrupted;
  }
  fmt::print("{:<32}  undecidable pixels\n", "case");
  for (const BuiltCase& c : built.cases)
    fmt::print("{:<32}  {:6.3f} %{}\n", c.id, 100 * c.undecidable_share, c.guessed ? "  (guessed from pictures)" : "");
  if (request.jitters > 0) fmt::print("seed of the further views: {}\n", request.seed);
  fmt::print("{} known mistakes show in these cases\n\nSuite: {}\n", built.fingerprints,
             (fs::path(a.out) / "suite.toml").string());
  return 0;
}

int verify(const std::string& built) {
  const std::vector<std::string> faults = verify_suite(built);
  for (const std::string& fault : faults) fmt::print("{}\n", fault);
  if (faults.empty()) fmt::print("{}: every file is as it was built\n", built);
  return faults.empty() ? 0 : 1;
}

void add_build(CLI::App& suite, Action& action) {
  CLI::App* command = suite.add_subcommand(
      "build", "Work out what correct programs may draw in each case, and what known mistakes draw");
  const auto arguments = std::make_shared<Arguments>();
  Arguments& a = *arguments;
  command->add_option("suite", a.suite, "The suite (docs/suite-format.md)")->required()->type_name("SUITE.toml");
  command->add_option("-o,--output", a.out, "The folder to make")->required()->type_name("BUILT");
  command->add_option("--jitters", a.jitters, "Further views of each scene, their cameras moved by a secret seed")
      ->check(CLI::Range(0, 100))
      ->type_name("K");
  command->add_option("--seed", a.seed, "Of the further views [drawn]")->type_name("S");
  command
      ->add_option("--from-pictures", a.pictures,
                   "Known-correct pictures, CASE/*.png below it, in place of scenes of ours")
      ->type_name("DIR");
  command->add_option("--mutants", a.mutants, "The programs with known mistakes [those of ./dev mutants]")
      ->type_name("DIR");
  command->add_flag("--without-fingerprints", a.without_fingerprints, "No pictures of known mistakes: no diagnosis");
  command->callback([&action, arguments] { action = [arguments] { return build(*arguments); }; });
}

}  // namespace

void add_suite_command(CLI::App& app, Action& action) {
  CLI::App* suite = app.add_subcommand("suite", "Build a suite to grade by, verify one, measure it by known mistakes");
  suite->require_subcommand(1);
  add_build(*suite, action);
  add_suite_score_command(*suite, action);
  CLI::App* command = suite->add_subcommand("verify", "Whether every file of a built suite is as it was built");
  const auto built = std::make_shared<std::string>();
  command->add_option("built", *built, "What 'plumb suite build' made")->required()->type_name("BUILT");
  command->callback([&action, built] { action = [built] { return verify(*built); }; });
}

}  // namespace plumb

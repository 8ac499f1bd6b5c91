#include "tools/plumb/suite_score_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "conformance/judge/score_suite.h"
#include "conformance/sandbox/run_process.h"
#include "renderer/image/staged_file.h"
#include "renderer/math/input_error.h"
#include "reports/kill_matrix_html.h"
#include "reports/kill_matrix_tables.h"
#include "reports/kill_matrix_text.h"
#include "tools/plumb/grading.h"
#include "tools/plumb/progress_bar.h"
#include "tools/plumb/shipped.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string built, out, filter, mutants;
  std::uint64_t seed = 1;
  double intensity = 1;
};

void require_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder))
    throw InputError({folder.string()}, "cannot make the folder for the kill matrix: " + error.message());
  require_writable(folder / "kill-matrix.csv");
}

int score(const Arguments& a) {
  SuiteScoreRequest request;
  request.built = a.built;
  request.mutants = a.mutants.empty() ? shipped_mutants() : fs::path(a.mutants);
  request.known_mistakes = shipped_known_mistakes();
  request.tracer = fs::read_symlink("/proc/self/exe");
  request.filter = a.filter;
  request.seed = a.seed;
  request.intensity = a.intensity;
  request.plumb_version = PLUMB_VERSION;
  const fs::path out = a.out.empty() ? fs::path("plumb-results/score") : fs::path(a.out);
  require_folder(out);

  stop_on_signals();
  SuiteScore result;
  {
    ProgressBar bar("score");
    request.progress = [&](const std::string&, double share) { bar.show(share); };
    result = score_suite(request);
  }
  if (interrupt_flag()) return kInterrupted;
  write_file_staged(out / "kill-matrix.csv", kill_matrix_csv(result));
  write_file_staged(out / "kill-matrix.json", kill_matrix_json(result));
  write_file_staged(out / "kill-matrix.html", kill_matrix_html(result));
  fmt::print("{}\nKill matrix: {}\n", kill_matrix_text(result), (out / "kill-matrix.html").string());
  return result.exit_status();
}

}  // namespace

void add_suite_score_command(CLI::App& suite, Action& action) {
  CLI::App* command = suite.add_subcommand("score", "Measure a suite by the known mistakes: which case notices which");
  const auto arguments = std::make_shared<Arguments>();
  Arguments& a = *arguments;
  command->add_option("built", a.built, "What 'plumb suite build' made, with fingerprints")
      ->required()
      ->type_name("BUILT");
  command->add_option("--out", a.out, "Where kill-matrix.html, .csv and .json go [plumb-results/score]")
      ->type_name("DIR");
  command->add_option("--filter", a.filter, "Only the known mistakes whose id matches")->type_name("GLOB");
  command->add_option("--seed", a.seed, "Of checks and growth cases")->type_name("S")->capture_default_str();
  command->add_option("--intensity", a.intensity, "How much the checks ask")
      ->check(CLI::PositiveNumber)
      ->type_name("X")
      ->capture_default_str();
  command->add_option("--mutants", a.mutants, "The programs with known mistakes [those of ./dev mutants]")
      ->type_name("DIR");
  command->callback([&action, arguments] { action = [arguments] { return score(*arguments); }; });
}

}  // namespace plumb

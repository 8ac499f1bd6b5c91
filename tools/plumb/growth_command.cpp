#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <optional>

#include "conformance/judge/calibrate_growth.h"
#include "conformance/sandbox/run_process.h"
#include "renderer/image/staged_file.h"
#include "reports/calibration_text.h"
#include "tools/plumb/command.h"
#include "tools/plumb/grading.h"
#include "tools/plumb/shipped.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string submission;
  std::string suite;
  std::string out;
  std::string filter;
  std::optional<std::uint64_t> seed;
  bool calibrate = false;
  int gates = 210;
};

fs::path shipped_suite() { return shipped_folder() / "suites/growth.toml"; }

/// The error rates of the gate itself, measured on programs of known growth.
int calibrate(const Arguments& arguments) {
  CalibrationRequest request;
  request.subjects = arguments.submission;
  request.suite = read_suite(arguments.suite.empty() ? shipped_suite() : fs::path(arguments.suite));
  const fs::path out = arguments.out.empty() ? fs::path("plumb-results/growth-calibration") : fs::path(arguments.out);
  fs::create_directories(out);
  request.record = out / "decisions.jsonl";
  request.gates = arguments.gates;
  request.plumb_version = PLUMB_VERSION;
  request.progress = [&](const std::string& what, int done) {
    fmt::print(stderr, "{}/{} {}\n", done + 1, arguments.gates, what);
  };
  fmt::print("not isolated: run only programs you trust\n");
  std::fflush(stdout);
  stop_on_signals();
  const std::string text = calibration_text(calibrate_growth(request));
  write_file_staged(out / "table.md", text);
  fmt::print("{}\nRecord and table: {}\n", text, out.string());
  return interrupt_flag() ? kInterrupted : 0;
}

int run(const Arguments& arguments) {
  if (arguments.calibrate) return calibrate(arguments);
  GradeRequest request;
  request.submission = arguments.submission;
  request.suite = read_suite(arguments.suite.empty() ? shipped_suite() : fs::path(arguments.suite));
  request.out = arguments.out.empty() ? default_results(request.submission) : fs::path(arguments.out);
  request.filter = arguments.filter;
  request.kind = "growth";
  if (arguments.seed)
    for (SuiteCase& c : request.suite.cases) c.growth.seed = arguments.seed;
  return grade_and_report(std::move(request));
}

}  // namespace

void add_growth_command(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("growth", "Decide whether a submission's time is sublinear in the size of the scene");
  const auto arguments = std::make_shared<Arguments>();
  Arguments& a = *arguments;
  command
      ->add_option("submission", a.submission,
                   "The folder that was handed in; with --calibrate, a folder of them with expected.toml")
      ->required()
      ->type_name("SUBMISSION");
  command
      ->add_option("--suite", a.suite, "A suite with cases of kind growth [the shipped one, for the course's scenes]")
      ->type_name("SUITE.toml");
  command->add_option("--out", a.out, "Where the results go [plumb-results/SUBMISSION]")->type_name("DIR");
  command->add_option("--filter", a.filter, "Only the cases whose id matches, and those they require")
      ->type_name("GLOB");
  command->add_option("--seed", a.seed, "Of meshes, cameras and names [another one each time]")->type_name("N");
  command->add_flag("--calibrate", a.calibrate,
                    "Measure the gate's own error rates on programs of known growth; goes on where it was interrupted");
  command->add_option("--gates", a.gates, "--calibrate: how many gates to run in all")
      ->type_name("N")
      ->capture_default_str();
  command->callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace plumb

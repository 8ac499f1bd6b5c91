#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <memory>
#include <set>
#include <vector>

#include "conformance/judge/grade.h"
#include "conformance/sandbox/run_process.h"
#include "reports/terminal_table.h"
#include "tools/plumb/command.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

constexpr int kInterrupted = 130;

struct Arguments {
  std::string submission;
  std::string suite;
  std::string out;
  std::string filter;
};

/// The longest that the cases may take, by their limits.
double longest_seconds(const Suite& suite, const std::set<std::size_t>& cases) {
  double seconds = suite.build_seconds;
  for (const std::size_t i : cases) seconds += suite.cases[i].wall_seconds;
  return std::min(seconds, suite.total_seconds);
}

void stop_on_signals() {
  struct sigaction action {};
  action.sa_handler = [](int) { interrupt_flag() = true; };
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
}

fs::path default_out(const fs::path& submission) {
  return fs::path("plumb-results") / fs::weakly_canonical(submission).filename();
}

int run(const Arguments& arguments) {
  GradeRequest request;
  request.submission = arguments.submission;
  request.suite = read_suite(arguments.suite);
  request.out = arguments.out.empty() ? default_out(request.submission) : fs::path(arguments.out);
  request.filter = arguments.filter;
  request.plumb_version = PLUMB_VERSION;
  const bool on_terminal = ::isatty(STDERR_FILENO) == 1;
  if (on_terminal) request.progress = [](const std::string& what) { fmt::print(stderr, "\r\x1b[K{} ...", what); };

  const std::set<std::size_t> cases = selected_cases(request.suite, request.filter);
  fmt::print("Suite {}: {} case{}, at most {:.0f} s.\n", request.suite.id, cases.size(), cases.size() == 1 ? "" : "s",
             longest_seconds(request.suite, cases));
  fmt::print("not isolated: run only programs you trust\n\n");
  std::fflush(stdout);
  stop_on_signals();
  const ResultSet results = grade(request);
  if (on_terminal) fmt::print(stderr, "\r\x1b[K");

  fmt::print("{}\nResults, pictures and logs: {}\n", terminal_table(results, {.color = ::isatty(STDOUT_FILENO) == 1}),
             request.out.string());
  if (interrupt_flag()) return kInterrupted;
  std::vector<Verdict> verdicts;
  for (const CaseResult& c : results.cases) verdicts.push_back(c.check.verdict);
  return exit_status(verdicts);
}

}  // namespace

void add_grade_command(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("grade", "Grade a submission: build it, run each case of a suite, judge what comes out");
  const auto arguments = std::make_shared<Arguments>();
  Arguments& a = *arguments;
  command->add_option("submission", a.submission, "The folder that was handed in")->required()->type_name("SUBMISSION");
  command->add_option("--suite", a.suite, "The suite (docs/suite-format.md)")->required()->type_name("SUITE.toml");
  command->add_option("--out", a.out, "Where the results go [plumb-results/SUBMISSION]")->type_name("DIR");
  command->add_option("--filter", a.filter, "Only the cases whose id matches, and those they require")
      ->type_name("GLOB");
  command->callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace plumb

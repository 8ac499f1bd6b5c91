#include "tools/plumb/grading.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <set>
#include <vector>

#include "conformance/sandbox/run_process.h"
#include "renderer/image/staged_file.h"
#include "reports/growth_text.h"
#include "reports/terminal_table.h"
#include "tools/plumb/draw.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// The longest that the cases may take, by their limits.
double longest_seconds(const Suite& suite, const std::set<std::size_t>& cases) {
  double seconds = suite.build_seconds;
  for (const std::size_t i : cases) {
    const SuiteCase& c = suite.cases[i];
    seconds += c.kind == "growth" ? c.growth.budget_seconds : c.wall_seconds;
  }
  return std::min(seconds, suite.total_seconds);
}

/// Cases that share a gate share its figures: they are said once, and drawn beside each.
void report_growth(const ResultSet& results, const fs::path& gnuplot, const fs::path& out) {
  std::vector<std::string> said;
  for (const CaseResult& c : results.cases) {
    if (!c.growth) continue;
    const std::string text = growth_text(*c.growth);
    const fs::path folder = out / "cases" / c.id;
    write_file_staged(folder / "growth.txt", text);
    draw(gnuplot, folder, growth_plot(*c.growth));
    if (std::ranges::find(said, text) == said.end())
      fmt::print("\n{} ({}/growth.svg)\n{}", c.id, folder.string(), text);
    said.push_back(text);
  }
}

}  // namespace

void stop_on_signals() {
  struct sigaction action {};
  action.sa_handler = [](int) { interrupt_flag() = true; };
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
}

fs::path default_results(const fs::path& submission) {
  return fs::path("plumb-results") / fs::weakly_canonical(submission).filename();
}

int grade_and_report(GradeRequest request) {
  request.plumb_version = PLUMB_VERSION;
  const bool on_terminal = ::isatty(STDERR_FILENO) == 1;
  if (on_terminal) request.progress = [](const std::string& what) { fmt::print(stderr, "\r\x1b[K{} ...", what); };

  const std::set<std::size_t> cases = selected_cases(request.suite, request.filter, request.kind);
  const bool draws = std::ranges::any_of(cases, [&](std::size_t i) { return request.suite.cases[i].kind == "growth"; });
  const fs::path gnuplot = draws ? gnuplot_program("the growth gate") : fs::path();
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
  if (draws) report_growth(results, gnuplot, request.out);
  std::vector<Verdict> verdicts;
  for (const CaseResult& c : results.cases) verdicts.push_back(c.check.verdict);
  return exit_status(verdicts);
}

}  // namespace plumb

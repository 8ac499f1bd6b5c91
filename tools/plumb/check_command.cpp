#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <memory>
#include <optional>

#include "conformance/checks/run_checks.h"
#include "conformance/judge/grade.h"
#include "conformance/results/write_results.h"
#include "conformance/sandbox/run_process.h"
#include "conformance/sandbox/temporary_folder.h"
#include "conformance/subject/kernel_cost.h"
#include "conformance/subject/kernel_subject.h"
#include "conformance/subject/shipped_kernels.h"
#include "renderer/math/input_error.h"
#include "reports/terminal_table.h"
#include "tools/plumb/command.h"
#include "tools/plumb/pareto.h"
#include "tools/plumb/subjects.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

constexpr int kInterrupted = 130;
/// Of processor time, for one check of a folder's program.
constexpr double kFolderSeconds = 600;

struct Arguments {
  SubjectArguments subject;
  std::string suite, out, filter;
  double intensity = 1;
  std::uint64_t seed = 1;
  bool json = false, list = false, pareto = false;
};

int list_all() {
  for (const CheckKind* check : checks_in_order()) {
    fmt::print("{:<16}  {}\n", check->id, check->title);
    fmt::print("{:<16}  asks:      {}\n", "", check->asks);
    fmt::print("{:<16}  matters:   {}\n", "", check->matters);
    fmt::print("{:<16}  tolerance: {}\n\n", "", check->tolerance);
  }
  fmt::print("shipped subjects: plumb");
  for (const std::string& name : shipped_kernel_names())
    if (name != "plumb") fmt::print(", {}", name);
  fmt::print("\n");
  return 0;
}

std::string repeat_command(const SubjectArguments& subject) {
  std::string command = "plumb check";
  if (!subject.subject.empty()) command += " " + fs::path(subject.subject).filename().string();
  if (!subject.probe.empty()) command += " --probe ...";
  return command;
}

void stop_on_signals() {
  struct sigaction action {};
  action.sa_handler = [](int) { interrupt_flag() = true; };
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
}

int report(const Arguments& arguments, const ResultSet& results) {
  if (arguments.json)
    fmt::print("{}", results_text(results));
  else
    fmt::print("{}", terminal_table(results, {.color = ::isatty(STDOUT_FILENO) == 1}));
  if (!arguments.out.empty() && !arguments.json) fmt::print("\nResults: {}\n", arguments.out);
  if (interrupt_flag()) return kInterrupted;
  std::vector<Verdict> verdicts;
  for (const CaseResult& c : results.cases) verdicts.push_back(c.check.verdict);
  return exit_status(verdicts);
}

/// The program in a folder is built and asked as `plumb grade` does, each check a case of its own.
int check_folder(const Arguments& arguments) {
  GradeRequest request;
  request.submission = arguments.subject.subject;
  if (arguments.suite.empty())
    throw InputError({arguments.subject.subject},
                     "is a folder, expected --suite SUITE.toml, whose [runner] says how it is built and asked");
  request.suite = read_suite(arguments.suite);
  request.suite.cases.clear();
  for (const CheckKind* check : selected_checks(arguments.filter)) {
    SuiteCase one;
    one.id = one.filter = check->id;
    one.kind = "check";
    one.requirement = check->asks;
    one.intensity = arguments.intensity;
    one.seed = arguments.seed;
    one.cpu_seconds = kFolderSeconds;
    one.wall_seconds = 3 * kFolderSeconds;
    request.suite.cases.push_back(std::move(one));
  }
  std::optional<TemporaryFolder> unwanted;
  if (arguments.out.empty()) unwanted.emplace("check");
  request.out = unwanted ? unwanted->path() / "results" : fs::path(arguments.out);
  request.plumb_version = PLUMB_VERSION;
  if (::isatty(STDERR_FILENO) == 1)
    request.progress = [](const std::string& what) { fmt::print(stderr, "\r\x1b[K{} ...", what); };
  const ResultSet results = grade(request);
  if (::isatty(STDERR_FILENO) == 1) fmt::print(stderr, "\r\x1b[K");
  return report(arguments, results);
}

/// What asking costs by itself, on this machine now: beside it every time of a kernel is to be read.
void print_asking_cost() {
  KernelSubject nothing(shipped_kernel("empty"));
  constexpr int kCalls = 200;
  const AskingCost one = asking_cost(nothing, 1, kCalls), many = asking_cost(nothing, 4096, kCalls);
  fmt::print("  cost of a call, by an empty kernel: {:.0f} ns for one ray, {:.2g} ns a ray for 4096 at once\n",
             one.cpu_nanoseconds_a_ray, many.cpu_nanoseconds_a_ray);
}

int check_subject(const Arguments& arguments) {
  ChecksRequest request;
  request.checks = selected_checks(arguments.filter);
  request.options.intensity = arguments.intensity;
  request.options.seed = arguments.seed;
  request.command = repeat_command(arguments.subject);
  request.plumb_version = PLUMB_VERSION;
  request.subject_id = subject_id(arguments.subject);
  OpenedSubject opened;
  std::optional<SubjectFailure> failure;
  try {
    opened = open_subject(arguments.subject);
  } catch (const SubjectFailure& error) {
    failure = error;
  }
  if (!arguments.json && !failure) {
    for (const auto& door : opened.doors)
      fmt::print("{}{}{}\n  contract: {}\n", door->name(), door->description().empty() ? "" : ": ", door->description(),
                 to_string(door->contract()));
    if (dynamic_cast<const KernelSubject*>(opened.doors.front().get())) print_asking_cost();
    fmt::print("\n");
    std::fflush(stdout);
  }
  if (::isatty(STDERR_FILENO) == 1)
    request.progress = [](const CheckKind& check, double share) {
      fmt::print(stderr, "\r\x1b[K{} {:.0f} % ...", check.id, 100 * share);
    };
  std::unique_ptr<ResultFolder> folder;
  if (!arguments.out.empty()) folder = std::make_unique<ResultFolder>(arguments.out, PLUMB_VERSION);
  request.done = [&](const CaseResult& result) {
    if (folder) folder->write_case(result);
  };
  const ResultSet results = failure ? failed_checks(request, *failure) : run_checks(request, opened.pointers());
  if (::isatty(STDERR_FILENO) == 1) fmt::print(stderr, "\r\x1b[K");
  if (folder) folder->finish(results);
  return report(arguments, results);
}

/// Asks no subject, but every kernel that is shipped.
int pareto(const Arguments& arguments) {
  if (!arguments.subject.subject.empty() || !arguments.subject.probe.empty() || !arguments.suite.empty())
    throw InputError({}, "--pareto asks the shipped kernels, expected no SUBJECT, --suite or --probe beside it");
  if (arguments.json) throw InputError({}, "--pareto writes CSV, expected no --json beside it");
  return run_pareto({arguments.out, arguments.filter, arguments.intensity, arguments.seed});
}

int run(const Arguments& arguments) {
  if (arguments.list) return list_all();
  if (arguments.pareto) return pareto(arguments);
  if (!arguments.json) fmt::print("not isolated: run only programs you trust\n\n");
  stop_on_signals();
  return fs::is_directory(arguments.subject.subject) ? check_folder(arguments) : check_subject(arguments);
}

}  // namespace

void add_check_command(CLI::App& app, Action& action, std::vector<std::string> probe) {
  CLI::App* command = app.add_subcommand(
      "check", "Check a subject's intersections, boxes, matrices and optics against exact arithmetic");
  const auto arguments = std::make_shared<Arguments>();
  Arguments& a = *arguments;
  command->add_option("subject", a.subject.subject, "plumb, a shipped kernel, a kernel's .so, or a folder with --suite")
      ->type_name("SUBJECT");
  command->add_option("--suite", a.suite, "How a folder is built and asked (docs/suite-format.md)")
      ->type_name("SUITE.toml");
  command->add_option("--out", a.out, "Store the result set there (docs/results.md)")->type_name("DIR");
  command->add_option("--filter", a.filter, "Only the checks whose id matches one of these, parted by commas")
      ->type_name("GLOB");
  command->add_option("--intensity", a.intensity, "How much is asked [1]")->check(CLI::PositiveNumber)->type_name("N");
  command->add_option("--seed", a.seed, "Same seed, same questions [1]")->type_name("S");
  command->add_flag("--json", a.json, "Print the results as JSON");
  command->add_flag("--list", a.list, "Say what each check asks, and which subjects are shipped");
  command->add_flag("--pareto", a.pareto, "Speed against error of every shipped kernel; --filter chooses kernels");
  a.subject.probe = std::move(probe);
  command->footer(
      "--probe COMMAND ...   instead of SUBJECT, and last: a probe's command, the rest of the line "
      "(docs/probe-protocol.md)");
  command->callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace plumb

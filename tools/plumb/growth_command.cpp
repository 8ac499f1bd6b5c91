#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "tools/plumb/command.h"
#include "tools/plumb/grading.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string submission;
  std::string suite;
  std::string out;
  std::string filter;
  std::optional<std::uint64_t> seed;
};

/// Beside the program that runs: `../share/plumb/suites/growth.toml`.
fs::path shipped_suite() {
  return fs::read_symlink("/proc/self/exe").parent_path().parent_path() / "share/plumb/suites/growth.toml";
}

int run(const Arguments& arguments) {
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
  command->add_option("submission", a.submission, "The folder that was handed in")->required()->type_name("SUBMISSION");
  command
      ->add_option("--suite", a.suite, "A suite with cases of kind growth [the shipped one, for the course's scenes]")
      ->type_name("SUITE.toml");
  command->add_option("--out", a.out, "Where the results go [plumb-results/SUBMISSION]")->type_name("DIR");
  command->add_option("--filter", a.filter, "Only the cases whose id matches, and those they require")
      ->type_name("GLOB");
  command->add_option("--seed", a.seed, "Of meshes, cameras and names [another one each time]")->type_name("N");
  command->callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace plumb

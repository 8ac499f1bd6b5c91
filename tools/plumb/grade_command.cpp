#include <CLI/CLI.hpp>
#include <memory>

#include "tools/plumb/command.h"
#include "tools/plumb/grading.h"
#include "tools/plumb/ready_suite.h"

namespace plumb {
namespace {

struct Arguments {
  std::string submission;
  std::string suite;
  std::string out;
  std::string filter;
};

int run(const Arguments& arguments) {
  GradeRequest request;
  request.submission = arguments.submission;
  request.suite = ready_suite(arguments.suite);
  request.out = arguments.out.empty() ? default_results(request.submission) : std::filesystem::path(arguments.out);
  request.filter = arguments.filter;
  return grade_and_report(std::move(request));
}

}  // namespace

void add_grade_command(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("grade", "Grade a submission: build it, run each case of a suite, judge what comes out");
  const auto arguments = std::make_shared<Arguments>();
  Arguments& a = *arguments;
  command->add_option("submission", a.submission, "The folder that was handed in")->required()->type_name("SUBMISSION");
  command->add_option("--suite", a.suite, "The suite (docs/suite-format.md), or one that was built")
      ->required()
      ->type_name("SUITE");
  command->add_option("--out", a.out, "Where the results go [plumb-results/SUBMISSION]")->type_name("DIR");
  command->add_option("--filter", a.filter, "Only the cases whose id matches, and those they require")
      ->type_name("GLOB");
  command->callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace plumb

#include "conformance/judge/grade_program.h"

#include <limits>

#include "conformance/judge/grade.h"
#include "conformance/sandbox/temporary_folder.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

Runner runner_of(const fs::path& program) {
  Runner runner;
  const std::string path = fs::absolute(program).string();
  runner.render = {path, "render", "{scene}", "-o", "{output}", "--threads", "1"};
  runner.probe = {path, "probe"};
  return runner;
}

}  // namespace

std::map<std::string, CheckResult> grade_program(const fs::path& program, const std::vector<Variant>& variants,
                                                 std::vector<SuiteCase> cases,
                                                 const std::function<void(const std::string&)>& progress) {
  std::map<std::string, CheckResult> results;
  if (cases.empty()) return results;
  const TemporaryFolder folder("program");  // for an empty submission, and the results
  GradeRequest request;
  request.submission = folder.path() / "submission";
  request.out = folder.path() / "results";
  fs::create_directory(request.submission);
  request.progress = progress;
  request.suite.id = program.filename().string();
  request.suite.variants = variants;
  request.suite.total_seconds = std::numeric_limits<double>::max();
  request.suite.has_runner = true;
  request.suite.runner = runner_of(program);
  for (SuiteCase& c : cases) c.prerequisites.clear();
  request.suite.cases = std::move(cases);
  for (CaseResult& c : grade(request).cases) results.emplace(c.id, std::move(c.check));
  return results;
}

}  // namespace plumb

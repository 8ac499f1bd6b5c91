#include "conformance/judge/grade_program.h"

#include <stdlib.h>

#include <cerrno>
#include <limits>
#include <system_error>

#include "conformance/judge/grade.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// Two folders for one grading, gone when this is: an empty submission, and the results.
class GradingFolders {
 public:
  GradingFolders() {
    std::string name = (fs::temp_directory_path() / "plumb-program-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::system_error(errno, std::generic_category(), "cannot make " + name);
    root_ = name;
    fs::create_directory(submission());
  }
  ~GradingFolders() {
    std::error_code ignored;
    fs::remove_all(root_, ignored);
  }
  GradingFolders(const GradingFolders&) = delete;
  GradingFolders& operator=(const GradingFolders&) = delete;
  fs::path submission() const { return root_ / "submission"; }
  fs::path results() const { return root_ / "results"; }

 private:
  fs::path root_;
};

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
  const GradingFolders folders;
  GradeRequest request;
  request.submission = folders.submission();
  request.out = folders.results();
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

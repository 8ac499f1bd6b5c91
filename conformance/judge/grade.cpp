#include "conformance/judge/grade.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <set>

#include "conformance/compare/judge_picture.h"
#include "conformance/judge/build_submission.h"
#include "conformance/judge/diagnose_results.h"
#include "conformance/judge/run_case.h"
#include "conformance/judge/run_growth_case.h"
#include "conformance/judge/workspace.h"
#include "conformance/results/write_results.h"
#include "conformance/sandbox/run_process.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Whether `inner` is `outer` or lies in it, links followed.
bool lies_in(const fs::path& inner, const fs::path& outer) {
  const fs::path a = fs::weakly_canonical(fs::absolute(inner));
  const fs::path b = fs::weakly_canonical(fs::absolute(outer));
  return std::mismatch(b.begin(), b.end(), a.begin(), a.end()).first == b.end();
}

/// Quoted where a shell would read something into it.
std::string shell_word(const std::string& word) {
  const bool plain =
      !word.empty() &&
      word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._/-") == std::string::npos;
  if (plain) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

void check_request(const GradeRequest& request) {
  if (!fs::is_directory(request.submission))
    throw InputError({request.submission.string()}, "the submission is no folder");
  if (lies_in(request.out, request.submission))
    throw InputError({request.out.string()}, "the results would lie inside the submission, expected --out elsewhere");
  if (lies_in(request.submission, request.out))
    throw InputError({request.out.string()},
                     "the submission lies inside the folder for the results, expected --out elsewhere");
  for (const SuiteCase& c : request.suite.cases) {
    if (c.kind != "image") continue;
    if (c.reference.empty())
      throw InputError({request.suite.file.string()},
                       "case '" + c.id + "' has no reference yet: build the suite first (plumb suite build)");
    if (lies_in(c.reference, request.submission))
      throw InputError({c.reference.string()}, "this reference lies inside the submission, which would see it");
    read_reference(c.reference);  // a broken one is found now, not in the middle of a class
  }
}

class Grader {
 public:
  explicit Grader(const GradeRequest& request)
      : request_(request),
        suite_(request.suite),
        results_(request.out, request.plumb_version),
        selected_(selected_cases(suite_, request.filter, request.kind)) {}

  ResultSet run() {
    set_.suite_id = suite_.id;
    set_.suite_hash = suite_.hash;
    set_.dialect = suite_.dialect;
    for (const Variant& v : suite_.variants) set_.variants.push_back(v.id);
    set_.submission_id = fs::weakly_canonical(request_.submission).filename().string();
    set_.plumb_version = request_.plumb_version;
    for (const SuiteCase& c : suite_.cases) set_.cases.push_back(blank_result(c));

    const std::optional<CheckResult> fault = prepare_safely();
    for (const std::size_t i : run_order(suite_)) {
      if (!selected_.contains(i)) continue;
      CaseResult& result = set_.cases[i];
      result.internal_message = prepare_message_;
      if (fault)
        result.check = *fault;
      else
        judge(suite_.cases[i], result);
      settle_points(suite_.cases[i], result);
      results_.write_case(result);
    }
    keep_selected();
    settle_variant();
    diagnose_results(suite_, results_, set_);
    results_.finish(set_);
    return std::move(set_);
  }

 private:
  /// A file of the submission that we cannot read, say, ends in results that wait for a person, not in none.
  std::optional<CheckResult> prepare_safely() {
    try {
      return prepare();
    } catch (const InputError&) {
      throw;
    } catch (const std::exception& error) {
      prepare_message_ = error.what();
      return internal_error();
    }
  }

  /// Copy, choice of the runner and build. Returns what went wrong for all cases.
  std::optional<CheckResult> prepare() {
    try {
      workspace_.copy_submission(request_.submission, suite_);
      choose_runner();
    } catch (const InputError& error) {
      return all_fail(error.what(), "check what was handed in against the assignment's list of files");
    }
    if (uses_suite_runner_) require_programs(suite_);
    note_left_out();
    if (!runner_.build.empty()) request_.progress("building");
    std::optional<CheckResult> fault = build_submission({suite_, runner_, workspace_, results_, seconds_left()});
    if (fault && fault->cause == "interrupted") fault->verdict = Verdict::skipped;
    return fault ? fault : seal();
  }

  /// A build that leaves pipes, or takes its own folder away, cannot be kept: its own fault.
  std::optional<CheckResult> seal() {
    try {
      workspace_.seal_build();
      return std::nullopt;
    } catch (const fs::filesystem_error&) {
      return all_fail("the build left something behind that is no ordinary file or folder, or removed its own folder",
                      "let the build write ordinary files only, below the folder it starts in");
    }
  }

  void note_left_out() {
    const std::vector<std::string>& roots = workspace_.roots();
    if (!roots.empty() && roots.front() != ".")
      set_.notes.push_back("the submission's root is its folder " + roots.front());
    for (std::size_t i = 1; i < roots.size(); ++i)
      set_.notes.push_back("not looked at, though it could be the root too: " + roots[i]);
    const LeftOut& left_out = workspace_.left_out();
    if (left_out.pictures > 0)
      set_.notes.push_back(fmt::format("{} picture{} of the submission left out: pictures are never copied",
                                       left_out.pictures, left_out.pictures == 1 ? "" : "s"));
    for (const std::string& name : left_out.not_ordinary)
      set_.notes.push_back("left out, as it is no ordinary file: " + name);
  }

  void choose_runner() {
    const fs::path own = workspace_.build() / "submission.toml";
    if (!suite_.own_runner) {
      if (fs::exists(own)) set_.notes.push_back("submission.toml was not read: the suite holds the commands");
      runner_ = suite_.runner;
      uses_suite_runner_ = true;
    } else if (fs::exists(own)) {
      runner_ = own_runner(own);
    } else if (suite_.has_runner) {
      runner_ = suite_.runner;
      uses_suite_runner_ = true;
    } else {
      throw InputError({}, "there is no submission.toml, which says how to build and run this submission");
    }
  }

  /// The message names the file as the student knows it, not the copy.
  static Runner own_runner(const fs::path& file) {
    try {
      return read_submission_runner(file);
    } catch (const InputError& error) {
      std::string text = error.what();
      if (text.starts_with(file.string())) text = "submission.toml" + text.substr(file.string().size());
      throw InputError({}, text);
    }
  }

  static CheckResult all_fail(const std::string& summary, const std::string& advice) {
    CheckResult result;
    result.verdict = Verdict::fail;
    result.cause = "build";
    result.summary = summary;
    result.advice = advice;
    return result;
  }

  CaseResult blank_result(const SuiteCase& c) const {
    CaseResult result;
    result.id = c.id;
    result.kind = c.kind;
    result.requirement = c.requirement;
    result.visibility = c.visibility;
    result.max_points = c.points;
    result.repeat = fmt::format("plumb grade {} --suite {} --filter {}",
                                shell_word(fs::weakly_canonical(request_.submission).filename().string()),
                                shell_word(suite_.file.filename().string()), c.id);
    return result;
  }

  void judge(const SuiteCase& c, CaseResult& result) {
    if (interrupt_flag()) {
      result.check = stop(Verdict::skipped, "interrupted", "grading was interrupted", "grade again");
      return;
    }
    if (seconds_left() <= 0) {
      result.check = stop(Verdict::timeout, "budget_spent", "the time for all cases together was spent",
                          "make the slow cases faster");
      return;
    }
    for (const std::size_t p : c.prerequisites) {
      const CaseResult& prerequisite = set_.cases[p];
      if (is_right(prerequisite.check.verdict)) continue;
      result.check = stop(Verdict::skipped, "prerequisite", "not judged: '" + prerequisite.id + "' comes first",
                          prerequisite.pending ? "a person has to look at '" + prerequisite.id + "' first"
                                               : "fix '" + prerequisite.id + "' first");
      result.pending = prerequisite.pending;
      return;
    }
    request_.progress(c.id);
    try {
      if (c.kind == "growth")
        growth_gates_.judge(c, runner_, workspace_, seconds_left(), results_, result);
      else
        run_case(c, runner_, workspace_, seconds_left(), results_, result);
    } catch (const std::exception& error) {  // our fault: it goes to a person, and the other cases go on
      result.check = internal_error();
      result.internal_message = error.what();
    }
  }

  double seconds_left() const {
    return suite_.total_seconds - std::chrono::duration<double>(Clock::now() - begin_).count();
  }

  static CheckResult internal_error() {
    return stop(Verdict::internal_error, "internal", "a fault of the grader, not of the submission (see usage.json)",
                "a person has to look at this case; it costs no points");
  }

  static CheckResult stop(Verdict verdict, const std::string& cause, const std::string& summary,
                          const std::string& advice) {
    CheckResult result = all_fail(summary, advice);
    result.verdict = verdict;
    result.cause = cause;
    return result;
  }

  /// A submission keeps to one of the accepted variants in all cases: to the one that gives it most points, the first
  /// of several.
  void settle_variant() {
    std::vector<double> points(suite_.variants.size());
    bool any = false;
    for (const CaseResult& c : set_.cases)
      for (std::size_t v = 0; v < c.by_variant.size(); ++v, any = true)
        if (is_right(c.by_variant[v].verdict)) points[v] += std::max(c.max_points, 1e-9);
    if (!any) return;
    const auto best = static_cast<std::size_t>(std::ranges::max_element(points) - points.begin());
    set_.variant = suite_.variants[best].id;
    for (CaseResult& c : set_.cases) {
      if (c.by_variant.empty()) continue;
      const auto other = std::ranges::find_if(c.by_variant, [](const CheckResult& r) { return is_right(r.verdict); });
      const bool was_right = is_right(c.check.verdict);
      c.check = c.by_variant[best];
      if (was_right && !is_right(c.check.verdict)) {
        const std::string& name = suite_.variants[static_cast<std::size_t>(other - c.by_variant.begin())].id;
        c.check.advice = "this picture is right by the variant '" + name + "', the others by '" + set_.variant +
                         "': keep to one in all cases";
        c.points = 0;
      }
      results_.write_case(c);
    }
  }

  void settle_points(const SuiteCase& c, CaseResult& result) const {
    const bool skipped = result.check.verdict == Verdict::skipped;
    if (result.check.verdict == Verdict::internal_error || result.check.cause == "interrupted") result.pending = true;
    if (skipped && suite_.skipped == SkippedPolicy::manual) result.pending = true;
    if (skipped && suite_.skipped == SkippedPolicy::excluded && !result.pending) result.excluded = true;
    result.points = is_right(result.check.verdict) ? c.points : 0;
  }

  void keep_selected() {
    std::vector<CaseResult> kept;
    for (const std::size_t i : selected_) kept.push_back(std::move(set_.cases[i]));
    set_.cases = std::move(kept);
  }

  const GradeRequest& request_;
  const Suite& suite_;
  Clock::time_point begin_ = Clock::now();
  ResultFolder results_;
  std::set<std::size_t> selected_;
  Workspace workspace_;
  Runner runner_;
  bool uses_suite_runner_ = false;
  std::string prepare_message_;
  GrowthGates growth_gates_{request_.progress};
  ResultSet set_;
};

}  // namespace

std::vector<std::size_t> run_order(const Suite& suite) {
  std::vector<std::size_t> by_cost(suite.cases.size());
  std::iota(by_cost.begin(), by_cost.end(), std::size_t{0});
  std::ranges::stable_sort(by_cost, {}, [&](std::size_t i) { return suite.cases[i].cpu_seconds; });
  std::vector<std::size_t> order;
  std::set<std::size_t> placed;
  const auto place = [&](const auto& self, std::size_t i) -> void {
    if (!placed.insert(i).second) return;
    for (const std::size_t p : suite.cases[i].prerequisites) self(self, p);
    order.push_back(i);
  };
  for (const std::size_t i : by_cost) place(place, i);
  return order;
}

std::set<std::size_t> selected_cases(const Suite& suite, const std::string& filter, const std::string& kind) {
  std::set<std::size_t> selected;
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < suite.cases.size(); ++i)
    if ((kind.empty() || suite.cases[i].kind == kind) &&
        (filter.empty() || ::fnmatch(filter.c_str(), suite.cases[i].id.c_str(), 0) == 0))
      open.push_back(i);
  if (open.empty() && filter.empty())
    throw InputError({suite.file.string()}, "no case of the suite is of kind " + kind);
  if (open.empty()) throw InputError({}, "--filter: no case of the suite matches '" + filter + "'");
  while (!open.empty()) {
    const std::size_t i = open.back();
    open.pop_back();
    if (selected.insert(i).second)
      open.insert(open.end(), suite.cases[i].prerequisites.begin(), suite.cases[i].prerequisites.end());
  }
  return selected;
}

ResultSet grade(const GradeRequest& request) {
  check_request(request);
  return Grader(request).run();
}

}  // namespace plumb

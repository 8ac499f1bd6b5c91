#include "conformance/checks/run_checks.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <ranges>

#include "conformance/sandbox/run_process.h"
#include "renderer/math/input_error.h"
#include "renderer/math/nearest_name.h"

namespace plumb {
namespace {

std::vector<std::string> parts(std::string_view filter) {
  std::vector<std::string> result;
  for (const auto part : std::views::split(filter, ',')) result.emplace_back(part.begin(), part.end());
  return result;
}

ResultSet empty_set(const ChecksRequest& request) {
  ResultSet set;
  set.suite_id = "checks";
  set.submission_id = request.subject_id;
  set.plumb_version = request.plumb_version;
  return set;
}

/// The case of a check, without its result.
CaseResult case_of(const CheckKind& check, const ChecksRequest& request) {
  CaseResult result;
  result.id = check.id;
  result.kind = "check";
  result.requirement = check.asks;
  result.visibility = "visible";
  result.max_points = 1;
  result.seed = request.options.seed;
  result.repeat = fmt::format("{} --filter {} --seed {} --intensity {:g}", request.command, check.id,
                              request.options.seed, request.options.intensity);
  return result;
}

CheckResult interrupted() {
  CheckResult result;
  result.verdict = Verdict::skipped;
  result.cause = "interrupted";
  result.summary = "checking was interrupted";
  result.advice = "check again";
  return result;
}

/// The smaller, the more it decides.
int severity(Verdict verdict) {
  switch (verdict) {
    case Verdict::internal_error:
      return 0;
    case Verdict::unsupported:
      return 2;
    case Verdict::skipped:
      return 2;
    case Verdict::quality_warning:
      return 3;
    case Verdict::pass:
      return 4;
    default:
      return 1;
  }
}

}  // namespace

std::vector<const CheckKind*> selected_checks(std::string_view filter) {
  std::vector<const CheckKind*> selected;
  std::vector<std::string_view> ids;
  const std::vector<const CheckKind*> all = checks_in_order();
  for (const CheckKind* check : all) ids.push_back(check->id);
  if (filter.empty()) return all;
  std::vector<bool> chosen(ids.size());
  for (const std::string& part : parts(filter)) {
    bool found = false;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (::fnmatch(part.c_str(), std::string(ids[i]).c_str(), 0) != 0) continue;
      found = chosen[i] = true;
    }
    if (!found)
      throw InputError({},
                       "--filter: no check matches '" + part + "'" + did_you_mean(part, ids) + " (plumb check --list)");
  }
  for (std::size_t i = 0; i < ids.size(); ++i)
    if (chosen[i]) selected.push_back(all[i]);
  return selected;
}

CheckResult ask_check(const CheckKind& check, std::span<Subject* const> doors, const CheckOptions& options) {
  std::vector<Subject*> order(doors.begin(), doors.end());
  if (check.probe_first) std::ranges::reverse(order);
  CheckResult result;
  for (Subject* door : order) {
    for (Subject* other : order)
      if (other != door) other->rest();
    result = run_check(check, *door, options);
    if (result.verdict != Verdict::unsupported) break;
  }
  return result;
}

ResultSet run_checks(const ChecksRequest& request, std::span<Subject* const> doors) {
  ResultSet set = empty_set(request);
  for (const CheckKind* check : request.checks) {
    CaseResult result = case_of(*check, request);
    if (interrupt_flag()) {
      result.check = interrupted();
      result.pending = true;
    } else {
      CheckOptions options = request.options;
      options.progress = [&](double share) { request.progress(*check, share); };
      request.progress(*check, 0);
      result.check = ask_check(*check, doors, options);
      result.points = is_right(result.check.verdict) ? 1 : 0;
      result.pending = result.check.verdict == Verdict::internal_error || result.check.cause == "interrupted";
    }
    request.done(result);
    set.cases.push_back(std::move(result));
  }
  return set;
}

ResultSet failed_checks(const ChecksRequest& request, const SubjectFailure& failure) {
  ResultSet set = empty_set(request);
  for (const CheckKind* check : request.checks) {
    CaseResult result = case_of(*check, request);
    result.check.verdict = failure.verdict();
    result.check.cause = failure.cause();
    result.check.summary = failure.what();
    result.check.advice = "start it by hand, and look at what it says";
    request.done(result);
    set.cases.push_back(std::move(result));
  }
  return set;
}

CheckResult combined(std::span<const CheckKind* const> checks, std::span<const CheckResult> results) {
  const auto worst = static_cast<std::size_t>(
      std::ranges::min_element(results, {}, [](const CheckResult& r) { return severity(r.verdict); }) -
      results.begin());
  CheckResult all = results[worst];
  if (results.size() == 1) return all;
  all.evidence.clear();
  const auto right = std::ranges::count_if(results, [](const CheckResult& r) { return is_right(r.verdict); });
  for (std::size_t i = 0; i < results.size(); ++i) {
    all.evidence.emplace_back(std::string(checks[i]->id), std::string(to_string(results[i].verdict)));
    all.evidence.emplace_back(std::string(checks[i]->id) + "_found", results[i].summary);
  }
  all.summary = fmt::format("{} of {} checks are right; {}: {}", right, results.size(), checks[worst]->id,
                            results[worst].summary);
  return all;
}

}  // namespace plumb

#include "conformance/checks/check.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace plumb {
namespace {

CheckResult without_answer(Verdict verdict, std::string cause, std::string summary) {
  CheckResult result;
  result.verdict = verdict;
  result.cause = std::move(cause);
  result.summary = std::move(summary);
  return result;
}

/// Smaller comes first; a word, which begins with a small letter, last.
std::pair<std::size_t, int> place(std::string_view id) {
  const std::size_t area = std::string_view("TBSCMAFN").find(id.front());
  if (area == std::string_view::npos) return {area, 0};
  return {area, std::stoi(std::string(id.substr(1)))};
}

}  // namespace

std::vector<const CheckKind*> checks_in_order() {
  std::vector<const CheckKind*> checks(check_kinds().begin(), check_kinds().end());
  std::ranges::stable_sort(checks, {}, [](const CheckKind* check) { return place(check->id); });
  return checks;
}

CheckResult run_check(const CheckKind& check, Subject& subject, const CheckOptions& options) {
  try {
    return check.run(subject, options);
  } catch (const UnsupportedBySubject& error) {
    return without_answer(Verdict::unsupported, "unsupported", error.what());
  } catch (const SubjectFailure& error) {
    return without_answer(error.verdict(), error.cause(), error.what());
  } catch (const std::exception& error) {
    return without_answer(Verdict::internal_error, "internal_error", error.what());
  }
}

}  // namespace plumb

#include "conformance/checks/check.h"

#include <exception>

namespace plumb {
namespace {

CheckResult without_answer(Verdict verdict, std::string cause, std::string summary) {
  CheckResult result;
  result.verdict = verdict;
  result.cause = std::move(cause);
  result.summary = std::move(summary);
  return result;
}

}  // namespace

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

#pragma once

#include <optional>
#include <string>

#include "conformance/judge/suite.h"
#include "conformance/sandbox/run_outcome.h"
#include "conformance/verdict.h"

namespace plumb {

/// A result without evidence.
CheckResult stopped(Verdict verdict, const std::string& cause, const std::string& summary, const std::string& advice);

/// The verdict of a run that did not come to its own end, or nothing. `cut_by_budget`: its time on the clock was what
/// the suite's time for all cases left.
std::optional<CheckResult> verdict_of_stop(const SuiteCase& c, const RunOutcome& run, bool cut_by_budget);

}  // namespace plumb

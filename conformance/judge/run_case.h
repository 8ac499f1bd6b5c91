#pragma once

#include "conformance/judge/suite.h"
#include "conformance/judge/workspace.h"
#include "conformance/results/result_set.h"
#include "conformance/results/write_results.h"

namespace plumb {

/// Runs one case in a fresh folder and judges it. `seconds_left` is what the suite's total_seconds leaves; a run that
/// it cuts short is `timeout` with the cause `budget_spent`. Fills in everything but the points. Throws only where the
/// fault is ours.
void run_case(const SuiteCase& suite_case, const Runner& runner, Workspace& workspace, double seconds_left,
              const ResultFolder& results, CaseResult& result);

}  // namespace plumb

#pragma once

#include "conformance/judge/suite.h"
#include "conformance/judge/workspace.h"
#include "conformance/results/result_set.h"
#include "conformance/results/write_results.h"

namespace plumb {

/// Starts the runner's probe, or loads its kernel, in a fresh folder of the built submission, runs the checks of a case
/// of kind check, and puts them together as one result (`combined`). The case's limits hold for all of its checks
/// together. Throws only where the fault is ours.
void run_check_case(const SuiteCase& suite_case, const Runner& runner, Workspace& workspace, double seconds_left,
                    const ResultFolder& results, CaseResult& result);

}  // namespace plumb

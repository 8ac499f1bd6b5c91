#pragma once

#include <map>
#include <span>
#include <string>

#include "conformance/mutants/mutant.h"
#include "conformance/results/score_results.h"
#include "conformance/verdict.h"

namespace plumb {

/// Sets the row's verdict, and what is missing, from its cells: one a column. `by_accepted_variant`: of a mutant that
/// is said to equal a variant, the results of the image cases by that variant alone; empty where the suite has no such
/// variant. What a column with a fault says counts for nothing.
void settle_mutant(const Mutant& mutant, std::span<const ScoreColumn> columns,
                   const std::map<std::string, CheckResult>& by_accepted_variant, ScoreRow& row);

/// Counts for each column what it notices, and for each case what no other case does.
void count_noticed(SuiteScore& score);

}  // namespace plumb

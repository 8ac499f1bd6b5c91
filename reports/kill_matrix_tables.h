#pragma once

#include <string>

#include "conformance/results/score_results.h"

namespace plumb {

/// The kill matrix as a table for programs [RFC 4180], a mutant a line: `mutant`, `step`, `verdict`, `missing`
/// (sentences parted by "; "), then a field for each case and check: the number of wrong pixels where a case has an
/// envelope and there is a picture, else a word of Notice.
std::string kill_matrix_csv(const SuiteScore& score);

/// All of the score as JSON: `counts`, `columns`, `mutants` with a cell for each column that was asked.
std::string kill_matrix_json(const SuiteScore& score);

}  // namespace plumb

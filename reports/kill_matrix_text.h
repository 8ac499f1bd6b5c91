#pragma once

#include <string>

#include "conformance/results/score_results.h"

namespace plumb {

/// The kill matrix for a terminal: mutants down, cases and checks across, a character a place, and a summary: a line
/// for whatever does not hold, what each case alone notices, and the cases that notice nothing.
std::string kill_matrix_text(const SuiteScore& score);

/// `caught by all that they name: 155 of 156 known mistakes; 1 by nothing; 3 more accepted as variants`
std::string score_summary(const SuiteScore& score);

/// A verdict in words: `caught by some of what it names`.
std::string verdict_text(const ScoreRow& row);

}  // namespace plumb

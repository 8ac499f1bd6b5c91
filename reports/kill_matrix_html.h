#pragma once

#include <string>

#include "conformance/results/score_results.h"

namespace plumb {

/// The kill matrix as a page that stands alone: style inline, no scripts, nothing fetched. Names of mutants and of
/// cases stay in sight where the table is scrolled; a place tells its wrong pixels and finding where the mouse rests on
/// it. Below it, what each case is worth. All texts are escaped.
std::string kill_matrix_html(const SuiteScore& score);

}  // namespace plumb

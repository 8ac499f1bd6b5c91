#pragma once

#include <string>

#include "conformance/results/pareto_results.h"

namespace plumb {

/// Speed against error as tables for a terminal: a kernel a column, first its speed, below it the figures, never
/// merged. None of N is written `<x`, x = 3/N per million (at 95 %); a kernel that failed has a dash.
std::string pareto_text(const ParetoResults& results);

/// `113218`, `2.5`, or `<30` for none.
std::string rate_text(const Rate& rate);

}  // namespace plumb

#pragma once

#include <string>

#include "conformance/results/growth_results.h"
#include "reports/pareto_csv.h"

namespace plumb {

/// What the growth gate measured of a program, as text for a terminal: a line a size, the slopes with their intervals,
/// how long it took, and what the figures mean for whoever wrote the program.
std::string growth_text(const GrowthFigures& figures);

/// The same figures as a script for gnuplot, `growth.gnuplot`: processor time a ray in each view over the size of the
/// scene, both axes logarithmic, beside lines in proportion to the size and to its square root.
ReportFile growth_plot(const GrowthFigures& figures);

}  // namespace plumb

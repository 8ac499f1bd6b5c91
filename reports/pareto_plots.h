#pragma once

#include <vector>

#include "conformance/results/pareto_results.h"
#include "reports/pareto_csv.h"

namespace plumb {

/// Scripts for gnuplot, each writing one picture in SVG to its standard output: `class.gnuplot`, `escapes.gnuplot`,
/// `closest.gnuplot`, `spheres.gnuplot` (speed against each figure, none among N rays as an open point at 3 / N), and
/// `pictures.gnuplot` (error against seconds).
std::vector<ReportFile> pareto_plots(const ParetoResults& results);

}  // namespace plumb

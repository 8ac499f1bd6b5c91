#pragma once

#include <filesystem>
#include <string>

#include "reports/pareto_csv.h"

namespace plumb {

/// Where gnuplot is. Throws InputError, in the name of `who`, where it is not in the PATH.
std::filesystem::path gnuplot_program(const std::string& who);

/// Writes a script for gnuplot, `NAME.gnuplot`, to the folder and its picture beside it, `NAME.svg`. Throws where
/// gnuplot fails.
void draw(const std::filesystem::path& gnuplot, const std::filesystem::path& folder, const ReportFile& script);

}  // namespace plumb

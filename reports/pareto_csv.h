#pragma once

#include <string>
#include <vector>

#include "conformance/results/pareto_results.h"

namespace plumb {

/// A file by its name, and what it holds.
struct ReportFile {
  std::string name;
  std::string text;
};

/// Speed against error as tables for programs [RFC 4180], a header line each: `run.csv` (version, seed, machine),
/// `kernels.csv` (speeds), `class.csv`, `escapes.csv`, `closest.csv`, `pictures.csv`. Counts stand beside the rates
/// that are made of them; numbers read back to the same doubles.
std::vector<ReportFile> pareto_csv(const ParetoResults& results);

/// A field as it stands in a line: in quotes, inner ones doubled, where it holds a comma, a quote or a line's end.
std::string csv_field(const std::string& text);

}  // namespace plumb

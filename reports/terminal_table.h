#pragma once

#include <string>

#include "conformance/results/result_set.h"

namespace plumb {

struct TableStyle {
  /// Colours, for a terminal.
  bool color = false;
};

/// A result set as a table for a terminal: a case a line with verdict, points and evidence, below it what to do where
/// there is something to do; then the notes and totals. Bytes of the submission that could command a terminal are
/// replaced.
std::string terminal_table(const ResultSet& results, const TableStyle& style);

}  // namespace plumb

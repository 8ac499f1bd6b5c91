#include "conformance/results/score_results.h"

#include <algorithm>

namespace plumb {

int SuiteScore::count(MutantVerdict verdict) const {
  return static_cast<int>(std::ranges::count(rows, verdict, &ScoreRow::verdict));
}

int SuiteScore::to_catch() const {
  return count(MutantVerdict::caught) + count(MutantVerdict::partly_caught) + count(MutantVerdict::elsewhere) +
         count(MutantVerdict::survives);
}

int SuiteScore::exit_status() const {
  if (std::ranges::any_of(columns, [](const ScoreColumn& c) { return !c.fault.empty(); })) return 3;
  return std::ranges::all_of(rows, is_settled, &ScoreRow::verdict) ? 0 : 1;
}

}  // namespace plumb

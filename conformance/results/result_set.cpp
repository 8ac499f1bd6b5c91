#include "conformance/results/result_set.h"

namespace plumb {

Totals ResultSet::totals() const {
  Totals totals;
  for (const CaseResult& c : cases) {
    if (c.pending) {
      totals.pending_points += c.max_points;
    } else if (!c.excluded) {
      totals.points += c.points;
      totals.max_points += c.max_points;
    }
  }
  return totals;
}

}  // namespace plumb

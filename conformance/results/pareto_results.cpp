#include "conformance/results/pareto_results.h"

namespace plumb {

double Rate::per_million() const { return of > 0 ? 1e6 * static_cast<double>(count) / static_cast<double>(of) : 0; }

double Rate::bound_per_million() const { return of > 0 ? 3e6 / static_cast<double>(of) : 0; }

}  // namespace plumb

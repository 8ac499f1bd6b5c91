#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace plumb {

/// The smallest of the sorted values that a share of them does not pass, `share` from 0 to 1; 0 of none.
inline double percentile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return 0;
  return sorted[static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size() - 1)))];
}

}  // namespace plumb

#include "conformance/families/random.h"

namespace plumb {

double Random::magnitude(double low, double high) {
  std::uint32_t doublings = 0;
  for (double bound = low; bound < high; bound *= 2) ++doublings;
  if (doublings == 0) return low;
  // The last power of two may be cut by `high`; drawing again keeps the rest even.
  while (true) {
    double value = low;
    for (std::uint32_t i = below(doublings); i > 0; --i) value *= 2;
    value *= 1 + unit();
    if (value <= high) return value;
  }
}

}  // namespace plumb

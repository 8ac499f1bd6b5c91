#include "conformance/envelopes/variant.h"

#include <algorithm>
#include <cmath>

namespace plumb {

int grid_side(int samples, SampleRounding rounding) {
  const double root = std::sqrt(static_cast<double>(samples));
  const double side = rounding == SampleRounding::up     ? std::ceil(root)
                      : rounding == SampleRounding::down ? std::floor(root)
                                                         : std::round(root);
  return std::max(1, static_cast<int>(side));
}

}  // namespace plumb

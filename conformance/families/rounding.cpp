#include "conformance/families/rounding.h"

namespace plumb {

double nearest_float(double x) { return static_cast<double>(static_cast<float>(x)); }

}  // namespace plumb

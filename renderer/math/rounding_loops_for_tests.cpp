// Compiled once at -O2 and once at -O3, into the namespace PLUMB_LEVEL.
#include <span>

#include "renderer/math/single_precision.h"
#include "renderer/math/vec3.h"

namespace plumb::PLUMB_LEVEL {

void round_points(std::span<Point3> points) {
  for (Point3& p : points) p = {rounded_to_single(p.x), rounded_to_single(p.y), rounded_to_single(p.z)};
}

void round_numbers(std::span<double> numbers) {
  for (double& x : numbers) x = rounded_to_single(x);
}

}  // namespace plumb::PLUMB_LEVEL

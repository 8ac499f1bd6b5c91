#pragma once

#include <limits>
#include <string>

#include "conformance/kernel/plumb_kernel.h"

namespace plumb {

/// What a subject says of itself; checks judge against it and name it. The values are those of plumb_kernel.h.
struct Contract {
  plumb_precision precision = PLUMB_DOUBLE;
  plumb_precision t_precision = PLUMB_DOUBLE;
  plumb_culling culling = PLUMB_CULL_NONE;
  plumb_edge_rule edge_rule = PLUMB_EDGE_WATERTIGHT;
  plumb_range range = PLUMB_RANGE_CLOSED;
  plumb_inside inside = PLUMB_INSIDE_HITS_EXIT;
  unsigned shapes = PLUMB_MESHES;
  unsigned capabilities = 0;
  /// Of |coordinate|; infinity for no limit.
  double largest = std::numeric_limits<double>::infinity();
  /// A probe answers what a kernel cannot: matrices, optics, frames.
  bool matrices = false, fresnel = false, refract = false, frame = false, average_position = false;
  /// Meshes pass through files whose numbers are single precision.
  bool float_meshes = false;
};

/// One line: `double in, double t, edges watertight, range closed, ...`.
std::string to_string(const Contract& contract);

}  // namespace plumb

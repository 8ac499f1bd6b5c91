#include "conformance/subject/contract.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace plumb {
namespace {

const char* precision_name(plumb_precision precision) { return precision == PLUMB_FLOAT ? "float" : "double"; }

const char* edge_name(plumb_edge_rule rule) {
  switch (rule) {
    case PLUMB_EDGE_CLOSED:
      return "closed";
    case PLUMB_EDGE_TOP_LEFT:
      return "top-left";
    case PLUMB_EDGE_WATERTIGHT:
      return "watertight";
    case PLUMB_EDGE_NONE:
      return "not promised";
  }
  return "?";
}

}  // namespace

std::string to_string(const Contract& c) {
  std::string text = fmt::format("{} in, {} t, edges {}, range {}, from inside {}", precision_name(c.precision),
                                 precision_name(c.t_precision), edge_name(c.edge_rule),
                                 c.range == PLUMB_RANGE_OPEN ? "open" : "closed",
                                 c.inside == PLUMB_INSIDE_MISSES ? "misses" : "hits the exit");
  if (c.culling == PLUMB_CULL_BACK) text += ", culls back faces";
  if (c.float_meshes) text += ", meshes in float";
  if (std::isfinite(c.largest)) text += fmt::format(", coordinates to {:g}", c.largest);
  return text;
}

}  // namespace plumb

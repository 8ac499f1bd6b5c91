#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind b03_edges_check_kind{
    .id = "B3",
    .title = "Rays at the edges and corners of boxes",
    .asks = "Rays as near to edges and corners as rounding allows.",
    .matters = "A false miss of a box prunes everything in it: holes in meshes along lines.",
    .tolerance = kBoundaryTolerance,
    .run =
        [](Subject& subject, const CheckOptions& options) {
          return check_family("B3", subject, options, TimeRule::judged, NormalRule::told, BoundaryRule::judged);
        },
};

}  // namespace plumb

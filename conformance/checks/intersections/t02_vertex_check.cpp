#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind t02_vertex_check_kind{
    .id = "T2",
    .title = "Rays at the vertices of triangles",
    .asks = "Rays through a vertex, as near as rounding allows.",
    .matters = "At a vertex many triangles can miss at once: bright or dark dots on closed surfaces.",
    .tolerance = kBoundaryTolerance,
    .run =
        [](Subject& subject, const CheckOptions& options) {
          return check_family("T2", subject, options, TimeRule::judged, NormalRule::told, BoundaryRule::judged);
        },
};

}  // namespace plumb

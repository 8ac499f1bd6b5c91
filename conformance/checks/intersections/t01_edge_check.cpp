#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind t01_edge_check_kind{
    .id = "T1",
    .title = "Rays at the edges of triangles",
    .asks = "Rays through points on an edge, as near as rounding allows: is the class of the triangle the exact one?",
    .matters =
        "Both neighbours of an edge miss and the background shines through in single pixels, or both hit and a shadow "
        "or refraction counts twice.",
    .tolerance = kBoundaryTolerance,
    .run =
        [](Subject& subject, const CheckOptions& options) {
          return check_family("T1", subject, options, TimeRule::judged, NormalRule::told, BoundaryRule::judged);
        },
};

}  // namespace plumb

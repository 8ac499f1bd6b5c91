#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind t07_far_check_kind{
    .id = "T7",
    .title = "Triangles far from the origin",
    .asks = "Triangles and rays with a large common offset.",
    .matters = "Objects far from the scene's origin get cracks.",
    .tolerance = kClassTolerance,
    .run = [](Subject& subject, const CheckOptions& options) { return check_family("T7", subject, options); },
};

}  // namespace plumb

#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind m03_mirrored_check_kind{
    .id = "M3",
    .title = "Mirroring transforms",
    .asks = "Surfaces under matrices of negative determinant: class, t, and the side of the normals.",
    .matters = "Mirrored objects are lit from the other side, or culled.",
    .tolerance =
        "As for the other families of single surfaces; normals within 0.01 degrees, but for one in a thousand, as a "
        "hit beside an edge has two.",
    .run =
        [](Subject& subject, const CheckOptions& options) {
          return check_family("M3", subject, options, TimeRule::judged, NormalRule::side);
        },
    .probe_first = true,
};

}  // namespace plumb

#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind m02_non_uniform_check_kind{
    .id = "M2",
    .title = "Non-uniform scales",
    .asks = "Surfaces scaled by different factors along the axes: class, t, and the normals where they are reported.",
    .matters =
        "Shading of squashed objects is wrong: the normal of diag(2,1,1) turned by the matrix is up to 37 degrees off.",
    .tolerance =
        "As for the other families of single surfaces; normals within 0.01 degrees, but for one in a thousand, as a "
        "hit beside an edge has two.",
    .run =
        [](Subject& subject, const CheckOptions& options) {
          return check_family("M2", subject, options, TimeRule::judged, NormalRule::line);
        },
    .probe_first = true,
};

}  // namespace plumb

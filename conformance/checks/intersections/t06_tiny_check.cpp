#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind t06_tiny_check_kind{
    .id = "T6",
    .title = "Tiny triangles",
    .asks = "Triangles whose determinant is far below the usual fixed epsilon.",
    .matters = "Finely tessellated models have holes.",
    .tolerance = kClassTolerance,
    .run = [](Subject& subject, const CheckOptions& options) { return check_family("T6", subject, options); },
};

}  // namespace plumb

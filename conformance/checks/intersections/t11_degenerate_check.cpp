#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind t11_degenerate_check_kind{
    .id = "T11",
    .title = "Degenerate triangles",
    .asks = "Triangles without area, and rays in the triangle's plane.",
    .matters = "A NaN from a degenerate triangle spreads through the hierarchy and leaves black or white blocks.",
    .tolerance = kClassTolerance,
    .run = [](Subject& subject, const CheckOptions& options) { return check_family("T11", subject, options); },
};

}  // namespace plumb

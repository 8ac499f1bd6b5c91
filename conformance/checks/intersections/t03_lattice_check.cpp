#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind t03_lattice_check_kind{
    .id = "T3",
    .title = "Rays exactly through edges and vertices",
    .asks = "Triangles with whole-number vertices, hit exactly on an edge or a vertex.",
    .matters = "Axis-aligned models seen along the axes lose lines of pixels.",
    .tolerance = kClassTolerance,
    .run = [](Subject& subject, const CheckOptions& options) { return check_family("T3", subject, options); },
};

}  // namespace plumb

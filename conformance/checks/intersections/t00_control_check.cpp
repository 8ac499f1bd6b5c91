#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind t00_control_check_kind{
    .id = "T0",
    .title = "Random rays at ordinary triangles",
    .asks = "Rays aimed at and past triangles of ordinary shape, far from any edge in units of rounding.",
    .matters = "Anything wrong here is wrong everywhere: whole surfaces are missing or show where they are not.",
    .tolerance = kClassTolerance,
    .run = [](Subject& subject, const CheckOptions& options) { return check_family("T0", subject, options); },
};

}  // namespace plumb

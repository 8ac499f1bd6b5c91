#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind c02_axis_check_kind{
    .id = "C2",
    .title = "Rays along and across the axis",
    .asks = "Rays parallel, perpendicular and nearly parallel to the axis of very long and very flat solids.",
    .matters = "The view along the axis is blank or full of NaN.",
    .tolerance = kClassTolerance,
    .run = [](Subject& subject, const CheckOptions& options) { return check_family("C2", subject, options); },
};

}  // namespace plumb

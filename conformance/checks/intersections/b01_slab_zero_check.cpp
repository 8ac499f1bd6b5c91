#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind b01_slab_zero_check_kind{
    .id = "B1",
    .title = "Rays along the faces of boxes",
    .asks = "Direction components of zero with the origin on a face's plane, or beside it.",
    .matters = "0 times infinity is NaN: boxes, and everything in them, vanish in axis-aligned views.",
    .tolerance = kClassTolerance,
    .run = [](Subject& subject, const CheckOptions& options) { return check_family("B1", subject, options); },
};

}  // namespace plumb

#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind t04_grazing_check_kind{
    .id = "T4",
    .title = "Rays that graze the triangle's plane",
    .asks = "Rays at an angle of almost nothing to the plane.",
    .matters = "Floors near the horizon and silhouettes flicker; shadows fall on the wrong side.",
    .tolerance = kClassTolerance,
    .run = [](Subject& subject, const CheckOptions& options) { return check_family("T4", subject, options); },
};

}  // namespace plumb

#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind t09_signed_zero_check_kind{
    .id = "T9",
    .title = "Directions with zeros of both signs",
    .asks = "Rays along the axes and planes of the axes, with +0 and -0.",
    .matters = "The view along an axis differs with the sign of a zero, or is blank.",
    .tolerance = kClassTolerance,
    .run = [](Subject& subject, const CheckOptions& options) { return check_family("T9", subject, options); },
};

}  // namespace plumb

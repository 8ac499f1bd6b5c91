#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind t08_scale_check_kind{
    .id = "T8",
    .title = "Huge and small numbers",
    .asks = "Scenes in units that make coordinates very large or very small.",
    .matters = "A scene in other units is blank: products overflow or underflow.",
    .tolerance = kClassTolerance,
    .run = [](Subject& subject, const CheckOptions& options) { return check_family("T8", subject, options); },
};

}  // namespace plumb

#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind m01_nested_check_kind{
    .id = "M1",
    .title = "Nested transforms",
    .asks = "Groups up to eight deep, conditions up to 10^12: t must be that of the world's ray.",
    .matters =
        "Surfaces in groups lie at the wrong distance: a transformed direction was made unit again, or the inverse is "
        "inexact.",
    .tolerance = kClassTolerance,
    .run = [](Subject& subject, const CheckOptions& options) { return check_family("M1", subject, options); },
};

}  // namespace plumb

#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind s03_tangent_check_kind{
    .id = "S3",
    .title = "Tangent rays",
    .asks = "Rays that touch a sphere, exactly or within 1 +- delta.",
    .matters = "Silhouettes are off by pixels, or hold NaN.",
    .tolerance = kClassTolerance,
    .run = [](Subject& subject, const CheckOptions& options) { return check_family("S3", subject, options); },
};

}  // namespace plumb

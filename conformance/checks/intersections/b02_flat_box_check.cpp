#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind b02_flat_box_check_kind{
    .id = "B2",
    .title = "Boxes without thickness",
    .asks = "Flat boxes hit across.",
    .matters = "Walls and floors made of thin boxes vanish, and so do flat meshes whose hierarchy uses the same test.",
    .tolerance = kBoundaryTolerance,
    .run =
        [](Subject& subject, const CheckOptions& options) {
          return check_family("B2", subject, options, TimeRule::judged, NormalRule::told, BoundaryRule::judged);
        },
};

}  // namespace plumb

#include <array>

#include "conformance/checks/bounds_question.h"

namespace plumb {

extern const CheckKind bounds_check_kind{
    .id = "bounds",
    .title = "Boxes of all surfaces",
    .asks =
        "World boxes of triangles, boxes, cylinders, cones and spheres, plain and in groups: do they contain, are they "
        "tight?",
    .matters = "A hierarchy never looks at what its box leaves out: parts of surfaces are missing.",
    .tolerance =
        "Containment is decided exactly. Loose is more than 4 units in the last place of the larger of coordinate and "
        "extent; never a failure.",
    .run =
        [](Subject& subject, const CheckOptions& options) {
          constexpr std::array<std::string_view, 12> kFamilies{"T0", "T5", "T7", "B0", "B2", "S0",
                                                               "S2", "C0", "C2", "M0", "M2", "M3"};
          return check_bounds(kFamilies, subject, options);
        },
};

}  // namespace plumb

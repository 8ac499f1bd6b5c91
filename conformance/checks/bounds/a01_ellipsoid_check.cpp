#include <array>

#include "conformance/checks/bounds_question.h"

namespace plumb {

extern const CheckKind a01_ellipsoid_check_kind{
    .id = "A1",
    .title = "Boxes of rotated ellipsoids",
    .asks = "World boxes of spheres and other round solids under rotation and scale: do they contain, are they tight?",
    .matters =
        "A box that cuts its surface makes a hierarchy lose it; the box of a transformed box is up to sqrt 3 too wide, "
        "which costs time.",
    .tolerance =
        "Containment is decided exactly: y^2 >= r^2 sum m_ij^2 for the distance y from the centre. Loose is more than "
        "4 "
        "units in the last place of the larger of coordinate and extent, which the roundings of the usual formula "
        "keep.",
    .run =
        [](Subject& subject, const CheckOptions& options) {
          constexpr std::array<std::string_view, 1> kFamilies{"A1"};
          return check_bounds(kFamilies, subject, options);
        },
};

}  // namespace plumb

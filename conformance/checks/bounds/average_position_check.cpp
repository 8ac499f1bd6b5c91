#include <array>

#include "conformance/checks/bounds_question.h"

namespace plumb {

extern const CheckKind average_position_check_kind{
    .id = "average-position",
    .title = "Average positions",
    .asks = "The point by which a hierarchy sorts a surface lies inside of the surface's world box.",
    .matters = "Nothing is missing from the picture, but the hierarchy splits in the wrong places and is slow.",
    .tolerance =
        "The closed box of the exact shape: a mean of points of a shape cannot leave it by more than its own rounding, "
        "which the box's rounding outwards covers.",
    .run =
        [](Subject& subject, const CheckOptions& options) {
          constexpr std::array<std::string_view, 7> kFamilies{"T0", "B0", "S0", "C0", "M0", "M2", "M3"};
          return check_average_positions(kFamilies, subject, options);
        },
};

}  // namespace plumb

#include <array>

#include "conformance/checks/matrix_question.h"

namespace plumb {

extern const CheckKind m04_right_angles_check_kind{
    .id = "M4",
    .title = "Rotations by right angles",
    .asks = "Matrices of rotations by 90, 180 and 270 degrees, whose entries are 0 and +-1.",
    .matters =
        "cos(90 pi / 180) is 6e-17 in doubles, not 0: harmless to a picture by itself, but boxes that should touch do "
        "not.",
    .tolerance =
        "Absolute, as the zeros have no relative error: 32 units of u |A1|...|An|, where each rotation's bound is 1 at "
        "most, so 32 u for a "
        "rotation alone. The error of pi / 180 in double is 1.3 u at 90 degrees and 4 u at 270.",
    .run =
        [](Subject& subject, const CheckOptions& options) {
          constexpr std::array<std::string_view, 1> kFamilies{"M4"};
          return check_matrices(kFamilies, subject, options);
        },
};

}  // namespace plumb

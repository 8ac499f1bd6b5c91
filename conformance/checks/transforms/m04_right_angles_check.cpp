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
        "As for all matrices: 32 units of what a plain product can lose, in which the error of a rotation's entries is "
        "absolute, as its zeros have no relative one. The cosine of 90 pi / 180 in doubles is off by 0.6 u, that of "
        "270 by 1.7 u.",
    .run =
        [](Subject& subject, const CheckOptions& options) {
          constexpr std::array<std::string_view, 1> kFamilies{"M4"};
          return check_matrices(kFamilies, subject, options);
        },
};

}  // namespace plumb

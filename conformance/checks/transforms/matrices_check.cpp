#include <array>

#include "conformance/checks/matrix_question.h"

namespace plumb {

extern const CheckKind matrices_check_kind{
    .id = "matrices",
    .title = "Matrices of nested groups",
    .asks =
        "The world matrix is the product of the groups' lines in file order, first outermost; its inverse and inverse "
        "transpose are those of that matrix.",
    .matters = "Everything in groups stands, turns or is lit wrongly; an inexact inverse moves what is deep in groups.",
    .tolerance =
        "32 units of u |A1|...|An| for a product and of u |A^-1||A||A^-1| for an inverse at 99 %, which plain "
        "arithmetic "
        "keeps; past 2^20 units it is another matrix.",
    .run =
        [](Subject& subject, const CheckOptions& options) {
          constexpr std::array<std::string_view, 4> kFamilies{"M0", "M1", "M2", "M3"};
          return check_matrices(kFamilies, subject, options);
        },
};

}  // namespace plumb

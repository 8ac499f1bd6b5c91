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
        "At 99 % 32 units of u B for a product, where B = |A1|...|An| and as much again for the entries of each "
        "rotation, and of u |A^-1| B |A^-1| for an inverse, which plain arithmetic keeps; past 2^20 units it is "
        "another matrix.",
    .run =
        [](Subject& subject, const CheckOptions& options) {
          constexpr std::array<std::string_view, 4> kFamilies{"M0", "M1", "M2", "M3"};
          return check_matrices(kFamilies, subject, options);
        },
};

}  // namespace plumb

#pragma once

#include <span>
#include <string_view>

#include "conformance/checks/check.h"

namespace plumb {

/// Asks the matrices of surfaces in nested groups and judges each entry:
/// - `world` against the true product of the lines of the groups, first outermost (certified_product);
/// - `inverse` and `inverse transpose` against the exact ones of the matrix that was reported.
///
/// An error is counted in units of u B, where B is what a plain product can lose: |A1||A2|...|An| and as much again for
/// each rotation's entries, whose error is absolute, for a product; |A^-1|B|A^-1| for an inverse, so that one made as
/// the product of inverses is right too [Higham 2002, sections 3.5 and 14.1]. Within 32 units (at 99 %) is a pass, to
/// 2^20 units quality_warning, past that the matrix is another one: `fail` with the cause `order` where the product in
/// another usual order fits, else `world`, `inverse` or `inverse_transpose`. Gold (evidence): 99 % within 32 ulps of
/// the entries themselves.
CheckResult check_matrices(std::span<const std::string_view> families, Subject& subject, const CheckOptions& options);

}  // namespace plumb

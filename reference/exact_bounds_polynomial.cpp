#include <CGAL/Mpzf.h>

#include "reference/exact_bounds_face.h"
#include "reference/exact_bounds_filter_number.h"
#include "reference/exact_bounds_reach.h"
#include "reference/exact_bounds_search.h"

namespace plumb {
namespace {

using Integer = CGAL::Mpzf;

FilterNumber value_of(const Reach<FilterNumber>::Term& term, const FilterNumber& root) {
  if (root.exact() && root.approximation() == 0) return term.middle;
  return term.middle + abs(term.numerator / term.denominator) * root;
}

FilterNumber filtered_reach(const Shape& shape, std::span<const Point3> vertices, const Row& row) {
  const Reach<FilterNumber> reach = reach_of<FilterNumber>(shape, vertices, row);
  const FilterNumber root = sqrt(reach.squares);
  const FilterNumber first = value_of(reach.terms[0], root);
  return reach.count == 1 ? first : max(first, value_of(reach.terms[1], root));
}

/// x >= middle + |numerator / denominator| sqrt(squares).
bool bounds(double x, const Reach<Integer>::Term& term, const Integer& squares) {
  const Integer beyond = Integer(x) - term.middle;
  if (beyond < 0) return false;
  const Integer left = beyond * term.denominator;
  return left * left >= term.numerator * term.numerator * squares;
}

}  // namespace

std::optional<double> upper_face_by_filter(const Shape& shape, std::span<const Point3> vertices, const Row& row) {
  return filtered_reach(shape, vertices, row).round_up();
}

double upper_face_by_polynomials(const Shape& shape, std::span<const Point3> vertices, const Row& row) {
  const Reach<Integer> reach = reach_of<Integer>(shape, vertices, row);
  const double guess = filtered_reach(shape, vertices, row).approximation();
  return smallest_that_holds(guess, [&](double x) {
    return bounds(x, reach.terms[0], reach.squares) && (reach.count == 1 || bounds(x, reach.terms[1], reach.squares));
  });
}

}  // namespace plumb

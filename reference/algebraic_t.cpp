#include "reference/algebraic_t.h"

namespace plumb {
namespace {

/// center + turn sqrt(square), with square >= 0 and turn -1, 0 or 1.
struct Surd {
  mpq_class center, square;
  int turn = 0;
};

Surd surd(const AlgebraicT& x) {
  if (x.a == 0) return {-x.c / x.b, 0, 0};
  const mpq_class half = x.b / (2 * x.a);
  Surd result{-half, half * half - x.c / x.a, x.root == 0 ? -1 : 1};
  if (result.square == 0) result.turn = 0;
  return result;
}

/// The sign of x + turn sqrt(square): where they pull in different directions the squares decide.
int sign_of_sum(const mpq_class& x, int turn, const mpq_class& square) {
  const int x_sign = sgn(x);
  const int root_sign = turn * sgn(square);
  if (x_sign * root_sign >= 0) return x_sign != 0 ? x_sign : root_sign;
  return x_sign * sgn(x * x - square);
}

}  // namespace

int compare(const AlgebraicT& x, const AlgebraicT& y) {
  const Surd p = surd(x), q = surd(y);
  // The sign of `rest` + `roots`, with rest = p.center - q.center and roots = p.turn sqrt(p.square) - q.turn
  // sqrt(q.square).
  const mpq_class rest = p.center - q.center;
  const int rest_sign = sgn(rest);
  const int roots_sign = p.turn == q.turn ? p.turn * cmp(p.square, q.square) : p.turn - q.turn;
  if (rest_sign == 0 || rest_sign * roots_sign >= 0) {
    const int sign = rest_sign != 0 ? rest_sign : roots_sign;
    return (sign > 0) - (sign < 0);
  }
  // They pull in different directions: the sign of rest^2 - roots^2 = rest^2 - p.square - q.square
  // + 2 p.turn q.turn sqrt(p.square q.square).
  const int larger = sign_of_sum(rest * rest - p.square - q.square, p.turn * q.turn, 4 * p.square * q.square);
  return rest_sign * larger;
}

}  // namespace plumb

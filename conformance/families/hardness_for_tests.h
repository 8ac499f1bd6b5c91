#pragma once

#include <cstdio>
#include <string>
#include <string_view>

#include "conformance/families/family.h"
#include "conformance/families/textbook_for_tests.h"

/// Counts what a formula makes of a family. Used by tests alone.
namespace plumb::textbook {

/// Below this margin the referee is not asked: its 113 bits lose 53 to the worst needle, which leaves 1e-18.
constexpr double kUndecided = 1e-17;

struct Tally {
  /// `near`: on an edge or tangent, by the referee's margin; those are not counted as wrong.
  int rays = 0, hits = 0, near = 0, wrong_class = 0, wrong_t = 0;
  int wrong() const { return wrong_class + wrong_t; }
  int hard() const { return near + wrong(); }
};

template <class Real>
void count(Tally& tally, const Answer<Quad>& truth, const Answer<Real>& naive) {
  ++tally.rays;
  tally.hits += truth.hit ? 1 : 0;
  if (truth.margin < kUndecided) {
    ++tally.near;
  } else if (truth.hit != naive.hit) {
    ++tally.wrong_class;
  } else if (truth.hit) {
    // Ten bits lost: no rounding of an ordinary case does that.
    const Quad unit = sizeof(Real) == 4 ? 0x1p-24 : 0x1p-53;
    const Quad error = magnitude(static_cast<Quad>(naive.t) - truth.t);
    if (!(error <= 1024 * unit * magnitude(truth.t))) ++tally.wrong_t;
  }
}

template <class Real>
using Naive = Answer<Real> (*)(const Shape&, const Line<Real>&);

template <class Real>
Answer<Real> plain(const Shape& shape, const Line<Real>& line) {
  return intersect<Real>(shape, line, false);
}

template <class Real>
Line<Real> object_line(const SubjectSurface& surface, const Ray& ray) {
  const Line<Real> line = line_of<Real>(ray);
  return surface.world_from_object == identity_matrix() ? line : in_object_space(surface.world_from_object, line);
}

/// The first `cases` of a family in Real's precision, before the naive formula and the referee; printed.
template <class Real>
Tally tally_of(std::string_view id, int cases, Naive<Real> naive = plain<Real>) {
  const auto family = family_kind(id).make(3, sizeof(Real) == 4 ? PLUMB_FLOAT : PLUMB_DOUBLE);
  Tally tally;
  for (int i = 0; i < cases; ++i) {
    const FamilyCase question = family->next();
    for (const Ray& ray : question.rays) {
      const Shape& shape = question.surface.shape;
      const Answer<Quad> truth = intersect(shape, object_line<Quad>(question.surface, ray), true);
      count<Real>(tally, truth, naive(shape, object_line<Real>(question.surface, ray)));
    }
  }
  const double percent = 100.0 / tally.rays;
  std::printf("%-4s %s: %6d rays, %5.1f %% hits, %6.3f %% near, %6.3f %% wrong class, %6.3f %% wrong t\n",
              std::string(id).c_str(), sizeof(Real) == 4 ? "float " : "double", tally.rays, percent * tally.hits,
              percent * tally.near, percent * tally.wrong_class, percent * tally.wrong_t);
  return tally;
}

}  // namespace plumb::textbook

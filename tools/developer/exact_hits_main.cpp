// Holds the renderer's hits against the oracle's, source by source, and prints a table for docs/certified-kernel.md:
//   exact_hits [RAYS] [ACCEL]
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "tools/developer/exact_hits.h"

namespace {

plumb::ExactHits all{.source = "all triangles and meshes"};

void print(const plumb::ExactHits& t) {
  fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} | {} of {} | {:.3g} | {} |{}\n", t.source, t.rays, t.hits,
             t.boundary, t.wrong_class, t.escapes, t.wrong_closest, t.wrong_t, t.wrong_range, t.range_questions,
             t.largest_t_error, t.wrong_if_rounded, t.first.empty() ? "" : " " + t.first);
  std::fflush(stdout);
}

/// Solids have no promise of exactness: their rows are printed, and not added.
void add(const plumb::ExactHits& t, bool is_flat) {
  if (t.rays == 0) return;
  print(t);
  if (!is_flat) return;
  all.rays += t.rays;
  all.hits += t.hits;
  all.boundary += t.boundary;
  all.wrong_class += t.wrong_class;
  all.escapes += t.escapes;
  all.wrong_closest += t.wrong_closest;
  all.wrong_t += t.wrong_t;
  all.wrong_range += t.wrong_range;
  all.range_questions += t.range_questions;
  all.wrong_if_rounded += t.wrong_if_rounded;
  all.largest_t_error = std::max(all.largest_t_error, t.largest_t_error);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace plumb;
  const std::int64_t count = argc > 1 ? std::atoll(argv[1]) : 1'000'000;
  const std::string_view name = argc > 2 ? argv[2] : "bvh8";
  const auto names = accel_names();
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) {
    fmt::print(stderr, "no such search: {}\n", name);
    return 2;
  }
  const auto accel = static_cast<Accel>(found - names.begin());
  fmt::print(
      "| source | rays | hits | boundary | wrong class | escapes | wrong closest | wrong t | wrong at t_min or t_max | "
      "largest error of t in bounds | wrong if rounded |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  // About 52 rows of triangles and meshes share the rays.
  const std::int64_t each = count / 52 + 1;
  for (const plumb_precision precision : {PLUMB_FLOAT, PLUMB_DOUBLE}) {
    for (const Placing placing : {Placing::as_given, Placing::placed}) {
      for (const FamilyKind* family : family_kinds())
        add(exact_hits_of(*family, precision, placing, accel, each), family->id.starts_with('T'));
      add(exact_hits_in_closed_meshes(precision, placing, accel, each), true);
      add(exact_hits_among_ties(precision, placing, accel, each), true);
    }
  }
  print(all);
  return all.wrong() == 0 ? 0 : 1;
}

#pragma once

#include <cstdint>
#include <string>

#include "conformance/families/family.h"
#include "renderer/accel/accelerator.h"

namespace plumb {

/// How the renderer's hits compare with the oracle's, over the rays of one source.
struct ExactHits {
  std::string source{};
  std::int64_t rays = 0;
  /// Of these the oracle says hit, and that its first crossing is on an edge or vertex.
  std::int64_t hits = 0, boundary = 0;
  /// Hit against miss, from `blocks` too; another surface or triangle than the exactly nearest one, equal ones by
  /// order; a t further from the exact one than the bound that is reported with it; on closed surfaces, a miss from
  /// inside.
  std::int64_t wrong_class = 0, wrong_closest = 0, wrong_t = 0, escapes = 0;
  /// Questions with t_min or t_max at the double below or above the exact t of the first crossing, or at t itself where
  /// it is a double.
  std::int64_t range_questions = 0, wrong_range = 0;
  /// What the same triangles would have got wrong, class or closest, by the rounded ray of their own frame and the
  /// order of the rounded t: that the questions are hard. Of scenes of at most 8 triangles.
  std::int64_t wrong_if_rounded = 0;
  /// Not asked: the renderer or the oracle takes no such surface.
  std::int64_t unsupported = 0;
  /// The largest error of a t as a part of its bound.
  double largest_t_error = 0;
  /// The first wrong answer, to be asked again.
  std::string first{};

  std::int64_t wrong() const { return wrong_class + wrong_closest + wrong_t + escapes + wrong_range; }
};

/// The shapes of the family as they stand, or (meshes and triangles alone) under matrices of a condition up to 1e6,
/// mirrored ones too, and up to 1e6 away.
enum class Placing { as_given, placed };

/// At least `count` rays. Triangles and meshes are held to the exact class, with edges and vertices belonging to them,
/// and to the exactly nearest triangle; solids to the class alone, and a tangent, rim or edge is free.
ExactHits exact_hits_of(const FamilyKind& family, plumb_precision precision, Placing placing, Accel accel,
                        std::int64_t count);

/// Rays from inside of closed meshes at vertices, edges and faces.
ExactHits exact_hits_in_closed_meshes(plumb_precision precision, Placing placing, Accel accel, std::int64_t count);

/// Triangles that coincide, or nearly: the same again, with its vertices turned, an ulp or two away, or another of the
/// same plane; in one mesh, in a surface each, and under matrices whose offsets are undone by the vertices.
ExactHits exact_hits_among_ties(plumb_precision precision, Placing placing, Accel accel, std::int64_t count);

}  // namespace plumb

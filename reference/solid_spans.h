#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "reference/exact_hit.h"
#include "reference/solid_line.h"

namespace plumb {

/// Names of the t at which a line meets the limits of a solid: 0 to 5 the planes of SolidLine, then the roots of its
/// side. A double root, and the one root of a side that is linear along the line, is kSmallerRoot.
constexpr int kSmallerRoot = 6;
constexpr int kLargerRoot = 7;
/// An interval that does not end.
constexpr int kNoRoot = -1;

struct SolidEnd {
  int root = kNoRoot;
  std::uint32_t part = 0;
  /// No other limit ends the interval at the same t.
  bool alone = true;
};

/// A maximal interval of a line within a solid.
struct SolidSpan {
  SolidEnd enter, leave;
  /// One point, which stands in both ends.
  bool single = false;
  bool free = false;
  bool tangent = false;
};

struct SolidSpans {
  std::array<SolidSpan, 2> items;
  std::size_t count = 0;
};

/// Appends the crossing at an end of the span; `from_min` and `from_max` are the signs of t - t_min and t - t_max,
/// within the range. The first one gives the hit its class.
inline void add_crossing(const SolidSpan& span, int from_min, int from_max, ExactCrossing crossing, ExactHit& hit) {
  crossing.free = span.free;
  crossing.place = from_min == 0 ? RangePlace::at_min : from_max == 0 ? RangePlace::at_max : RangePlace::within;
  if (hit.crossings.empty()) {
    hit.hit_class = span.tangent ? HitClass::tangent : span.free ? HitClass::boundary : HitClass::hit;
  }
  hit.crossings.push_back(crossing);
}

/// Finds the spans (see solid_hit.h for what is free), asking an algebra for signs only:
/// Line = SolidLine<N>, line(), sign(N), and compare(root, root). They come by t.
template <class Algebra>
class SpanFinder {
 public:
  explicit SpanFinder(Algebra& algebra) : algebra_(algebra), line_(algebra.line()) {}

  SolidSpans find() {
    if (!find_slabs()) return {};
    if (!line_.has_side) {
      add({kNoRoot, kNoRoot});
      return spans_;
    }
    const int a = algebra_.sign(line_.a);
    const int d = a == 0 ? 0 : algebra_.sign(line_.discriminant);
    if (a > 0 && d >= 0) {
      double_root_ = d == 0;
      add({kSmallerRoot, double_root_ ? kSmallerRoot : kLargerRoot});
    } else if (a < 0 && d > 0) {
      add({kNoRoot, kSmallerRoot});
      add({kLargerRoot, kNoRoot});
    } else if (a < 0) {
      // Through the tip of a cone and inside on both hands of it: one span. (Without a root a < 0 would be inside
      // throughout, but every line meets the plane of the tip, where the side's form is not negative.)
      double_root_ = true;
      add({kNoRoot, kNoRoot});
    } else if (a == 0) {
      find_linear();
    }
    return spans_;
  }

 private:
  using Piece = std::pair<int, int>;

  /// 2 b t + c <= 0.
  void find_linear() {
    const int b = algebra_.sign(line_.b);
    if (b != 0) return add(b > 0 ? Piece{kNoRoot, kSmallerRoot} : Piece{kSmallerRoot, kNoRoot});
    const int c = algebra_.sign(line_.c);
    along_side_ = c == 0;
    if (c <= 0) add({kNoRoot, kNoRoot});
  }

  bool find_slabs() {
    for (std::size_t i = 0; i < line_.plane_count; ++i) {
      const auto& plane = line_.planes[i];
      const int slope = algebra_.sign(plane.slope);
      if (slope > 0) raise(slabs_.enter, static_cast<int>(i), plane.part);
      if (slope < 0) lower(slabs_.leave, static_cast<int>(i), plane.part);
      if (slope != 0) continue;
      const int at = algebra_.sign(plane.at);
      if (at < 0) return false;
      if (at == 0) face_ = std::min(face_, plane.part);
    }
    return true;
  }

  void replace(SolidEnd& end, int root, std::uint32_t part, int order) {
    if (order > 0) {
      end = {root, part, true};
    } else if (order == 0) {
      end.part = std::min(end.part, part);
      end.alone = false;
    }
  }
  void raise(SolidEnd& end, int root, std::uint32_t part) {
    replace(end, root, part, end.root == kNoRoot ? 1 : algebra_.compare(root, end.root));
  }
  void lower(SolidEnd& end, int root, std::uint32_t part) {
    replace(end, root, part, end.root == kNoRoot ? 1 : algebra_.compare(end.root, root));
  }

  /// Intersects a piece of the side's inside with the slabs.
  void add(const Piece& side) {
    SolidSpan span = slabs_;
    if (side.first != kNoRoot) raise(span.enter, side.first, 0);
    if (side.second != kNoRoot) lower(span.leave, side.second, 0);
    if (span.enter.root == kNoRoot || span.leave.root == kNoRoot) return;
    const int order = algebra_.compare(span.enter.root, span.leave.root);
    if (order > 0) return;
    span.single = order == 0;
    name_faces(span.enter);
    name_faces(span.leave);
    const bool in_face = along_side_ || face_ != kNoFace;
    if (span.single) {
      span.tangent = double_root_ && side.first == kSmallerRoot;
      const bool through_flat = span.enter.alone && span.leave.alone && span.enter.root < kSmallerRoot &&
                                span.enter.root / 2 == span.leave.root / 2;
      span.free = in_face || span.tangent || !through_flat;
      span.enter.part = std::min(span.enter.part, span.leave.part);
    } else {
      span.free = in_face;
    }
    spans_.items[spans_.count++] = span;
  }

  /// Of the faces that hold the point, those that do not end the span there: the side at a cone's tip, or along the
  /// line.
  void name_faces(SolidEnd& end) {
    end.part = std::min(end.part, face_);
    const bool may_be_tip = double_root_ && end.root != kSmallerRoot && end.part != 0;
    if (along_side_ || (may_be_tip && algebra_.compare(end.root, kSmallerRoot) == 0)) end.part = 0;
  }

  static constexpr std::uint32_t kNoFace = 6;

  Algebra& algebra_;
  const typename Algebra::Line& line_;
  SolidSpan slabs_;
  std::uint32_t face_ = kNoFace;
  bool along_side_ = false;
  bool double_root_ = false;
  SolidSpans spans_;
};

}  // namespace plumb

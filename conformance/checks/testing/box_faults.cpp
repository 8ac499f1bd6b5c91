#include <algorithm>
#include <cmath>

#include "conformance/checks/testing/planted_fault.h"

namespace plumb::planted {
namespace {

/// Where the line is inside of the box, and how that is found.
struct Interval {
  double enter, leave;
};

/// A subject of boxes alone: `interval` by its own means, `meets(interval)` says whether there is anything.
template <class Slabs, class Meets>
std::function<std::unique_ptr<Subject>()> boxes(Slabs slabs, Meets meets) {
  return spoiled([=](Formulas& f) {
    f.contract.matrices = false;
    f.contract.shapes = PLUMB_BOXES;
    f.hits = [=](const Shape& shape, const Ray& ray) -> std::vector<LocalHit> {
      const Interval i = slabs(shape, ray);
      if (!meets(i)) return {};
      std::vector<LocalHit> hits;
      for (const double t : {i.enter, i.leave})
        if (ray.contains(t)) hits.push_back({.t = t});
      return hits;
    };
  });
}

/// Zeros looked at first; divisions, so that t is right to half an ulp.
Interval careful_slabs(const Shape& box, const Ray& ray) {
  Interval i{-Bounds3::kInfinity, Bounds3::kInfinity};
  for (int axis = 0; axis < 3; ++axis) {
    const double o = ray.origin[axis], d = ray.direction[axis];
    if (d == 0) {
      if (o < box.min[axis] || o > box.max[axis]) return {1, 0};
      continue;
    }
    const auto [near, far] = std::minmax({(box.min[axis] - o) / d, (box.max[axis] - o) / d});
    i = {std::max(i.enter, near), std::min(i.leave, far)};
  }
  return i;
}

/// 0 * infinity is NaN where the origin lies in a face's plane, and std::max(NaN, x) with its arguments this way round
/// forgets the slabs before it.
Interval slabs_by_reciprocal(const Shape& box, const Ray& ray) {
  Interval i{-Bounds3::kInfinity, Bounds3::kInfinity};
  for (int axis = 0; axis < 3; ++axis) {
    const double inverse = 1 / ray.direction[axis];
    double near = (box.min[axis] - ray.origin[axis]) * inverse;
    double far = (box.max[axis] - ray.origin[axis]) * inverse;
    if (inverse < 0) std::swap(near, far);
    i = {std::max(near, i.enter), std::min(far, i.leave)};
  }
  return i;
}

/// x and y alone.
Interval slabs_of_two_axes(const Shape& box, const Ray& ray) {
  Shape wrong = box;
  wrong.min.z = -Bounds3::kInfinity;
  wrong.max.z = Bounds3::kInfinity;
  return careful_slabs(wrong, ray);
}

}  // namespace

std::vector<Fault> box_faults() {
  const auto closed = [](const Interval& i) { return i.enter <= i.leave; };
  return {
      {"B0", "a slab is forgotten", Verdict::fail, "class", boxes(slabs_of_two_axes, closed)},
      {"B1", "0 * infinity in a face's plane makes other slabs forgotten", Verdict::fail, "not_finite",
       boxes(slabs_by_reciprocal, closed)},
      {"B2", "enter < leave, which a flat box never is", Verdict::fail, "boundary",
       boxes(careful_slabs, [](const Interval& i) { return i.enter < i.leave; })},
      {"B3", "the edges cut by a margin of 1e-6", Verdict::fail, "boundary",
       boxes(careful_slabs, [](const Interval& i) { return i.enter + 1e-6 < i.leave; })},
      {"B3", "rays from inside have to hit an entry", Verdict::fail, "escape", spoiled([](Formulas& f) {
         f.contract.matrices = false;
         f.contract.shapes = PLUMB_BOXES;
         f.hits = [](const Shape& shape, const Ray& ray) -> std::vector<LocalHit> {
           const Interval i = careful_slabs(shape, ray);
           if (!(i.enter <= i.leave) || !ray.contains(i.enter)) return {};
           return {{.t = i.enter}};
         };
       })},
  };
}

}  // namespace plumb::planted

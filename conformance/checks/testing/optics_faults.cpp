#include <cmath>

#include "conformance/checks/testing/planted_fault.h"

namespace plumb::planted {
namespace {

/// The unpolarised reflectance from both cosines.
double of_cosines(double near, double far, double from, double to) {
  const double parallel = (to * near - from * far) / (to * near + from * far);
  const double perpendicular = (from * near - to * far) / (from * near + to * far);
  return (parallel * parallel + perpendicular * perpendicular) / 2;
}

/// The square root of a negative number past the critical angle.
double without_total_reflection(double cosine, double from, double to) {
  return of_cosines(cosine, std::sqrt(1 - (from / to) * (from / to) * (1 - cosine * cosine)), from, to);
}

double perpendicular_alone(double cosine, double from, double to) {
  const double square = 1 - (from / to) * (from / to) * (1 - cosine * cosine);
  if (square <= 0) return 1;
  const double far = std::sqrt(square);
  const double perpendicular = (from * cosine - to * far) / (from * cosine + to * far);
  return perpendicular * perpendicular;
}

double schlick(double cosine, double from, double to) {
  const double r = (from - to) / (from + to);
  return r * r + (1 - r * r) * std::pow(1 - cosine, 5);
}

/// The construction by the cross product with y, which is zero along y.
std::array<Vec3, 3> by_the_y_axis(const Vec3& direction) {
  const Vec3 w = normalized(direction);
  const Vec3 u = normalized(cross(Vec3{0, 1, 0}, w));
  return {u, cross(w, u), w};
}

/// An axis that is not parallel, but the cross product not made unit.
std::array<Vec3, 3> not_unit(const Vec3& direction) {
  const Vec3 w = normalized(direction);
  const Vec3 u = cross(std::fabs(w.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, w);
  return {u, cross(w, u), w};
}

template <class Formula>
std::function<std::unique_ptr<Subject>()> fresnel_by(Formula formula) {
  return spoiled([=](Formulas& f) { f.fresnel = formula; });
}

template <class Formula>
std::function<std::unique_ptr<Subject>()> frame_by(Formula formula) {
  return spoiled([=](Formulas& f) { f.frame = formula; });
}

}  // namespace

std::vector<Fault> optics_faults() {
  return {
      {"F1", "the square root of a negative number past the critical angle", Verdict::fail, "total_reflection",
       fresnel_by(without_total_reflection), Right::formulas, 0.05},
      {"F1", "one polarisation alone", Verdict::fail, "reflectance", fresnel_by(perpendicular_alone), Right::formulas,
       0.05},
      {"F1", "the indices swapped", Verdict::fail, "total_reflection", spoiled([](Formulas& f) {
         f.fresnel = [right = f.fresnel](double cosine, double from, double to) { return right(cosine, to, from); };
       }),
       Right::formulas, 0.05},
      {"F1", "Schlick's approximation, where the exact one was asked", Verdict::fail, "total_reflection",
       fresnel_by(schlick), Right::formulas, 0.05},
      {"refraction", "the indices swapped", Verdict::fail, "total_reflection", spoiled([](Formulas& f) {
         f.refract = [right = f.refract](const Vec3& direction, const Vec3& normal, double from, double to) {
           return right(direction, normal, to, from);
         };
       }),
       Right::formulas, 0.05},
      {"refraction", "a normal that is turned the other way", Verdict::fail, "direction", spoiled([](Formulas& f) {
         f.refract = [right = f.refract](const Vec3& direction, const Vec3& normal, double from, double to) {
           std::optional<Vec3> bent = right(direction, normal, from, to);
           if (bent) bent = *bent - 2 * dot(*bent, normal) * normal;
           return bent;
         };
       }),
       Right::formulas, 0.05},
      {"N1", "a cross product with the y axis, straight up too", Verdict::fail, "frame", frame_by(by_the_y_axis),
       Right::formulas, 0.05},
      {"N1", "a cross product that is not made unit", Verdict::fail, "frame", frame_by(not_unit), Right::formulas,
       0.05},
  };
}

}  // namespace plumb::planted

#include "renderer/shaders/fresnel.h"

#include <array>
#include <cmath>

namespace plumb {

std::span<const std::string_view> fresnel_names() {
  static constexpr std::array<std::string_view, 2> kNames{"exact", "schlick"};
  return kNames;
}

namespace {

/// (to b)^2, where b is the cosine on the far side: (from c)^2 - (from - to)(from + to) by Snell's law. Below zero
/// under total internal reflection. Near the critical angle the two terms cancel; in 64 bits, and with the difference
/// of the indices exact where they are close, its sign is wrong within 2^-63 of that angle's cosine only.
long double squared_beyond(const Interface& interface) {
  const long double from = interface.from;
  const long double to = interface.to;
  const long double across = from * interface.cosine;
  return across * across - (from - to) * (from + to);
}

}  // namespace

std::optional<double> refracted_cosine(const Interface& interface) {
  const long double squared = squared_beyond(interface);
  if (!(squared >= 0)) return std::nullopt;
  return static_cast<double>(std::sqrt(squared) / interface.to);
}

double reflectance(const Interface& interface, Fresnel fresnel) {
  const long double squared = squared_beyond(interface);
  if (!(squared >= 0)) return 1;
  const long double cosine = interface.cosine;
  const long double from = interface.from;
  const long double to = interface.to;
  if (from == to) return 0;  // no interface; at grazing incidence the formulas below would divide zero by zero
  const long double beyond = std::sqrt(squared) / to;
  if (fresnel == Fresnel::schlick) {
    const double r0 = (interface.to - interface.from) / (interface.to + interface.from);
    const double thinner = from <= to ? interface.cosine : static_cast<double>(beyond);
    return r0 * r0 + (1 - r0 * r0) * std::pow(1 - thinner, 5);
  }
  // The amplitudes are (to c - from b) / (to c + from b) and (from c - to b) / (from c + to b). Where the indices are
  // close their numerators cancel; times the denominators, with b put in by Snell's law, they have the difference of
  // the indices as a factor.
  const long double difference = (from - to) * (from + to);
  const long double parallel_sum = to * cosine + from * beyond;
  const long double across_sum = from * cosine + to * beyond;
  const long double brewster = cosine * cosine * (from * from + to * to) - from * from;
  const long double parallel = -difference * brewster / (to * to * parallel_sum * parallel_sum);
  const long double across = difference / (across_sum * across_sum);
  return static_cast<double>((parallel * parallel + across * across) / 2);
}

Vec3 reflected(const Vec3& to_viewer, const Normal3& normal) {
  return 2 * dot(normal, to_viewer) * as_vector(normal) - to_viewer;
}

Vec3 refracted(const Vec3& to_viewer, const Normal3& normal, const Interface& interface, double refracted_cosine) {
  const double ratio = interface.from / interface.to;
  return (ratio * interface.cosine - refracted_cosine) * as_vector(normal) - ratio * to_viewer;
}

}  // namespace plumb

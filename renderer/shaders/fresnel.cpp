#include "renderer/shaders/fresnel.h"

#include <array>
#include <cmath>

namespace plumb {

std::span<const std::string_view> fresnel_names() {
  static constexpr std::array<std::string_view, 2> kNames{"exact", "schlick"};
  return kNames;
}

std::optional<double> refracted_cosine(const Interface& interface) {
  const double ratio = interface.from / interface.to;
  const double squared = 1 - ratio * ratio * (1 - interface.cosine * interface.cosine);
  if (!(squared >= 0)) return std::nullopt;
  return std::sqrt(squared);
}

double reflectance(const Interface& interface, Fresnel fresnel) {
  const std::optional<double> beyond = refracted_cosine(interface);
  if (!beyond) return 1;
  const auto [cosine, from, to] = interface;
  if (from == to) return 0;  // no interface; at grazing incidence the formulas below would divide zero by zero
  if (fresnel == Fresnel::schlick) {
    const double r0 = (to - from) / (to + from);
    const double thinner = from <= to ? cosine : *beyond;
    return r0 * r0 + (1 - r0 * r0) * std::pow(1 - thinner, 5);
  }
  const double parallel = (to * cosine - from * *beyond) / (to * cosine + from * *beyond);
  const double across = (from * cosine - to * *beyond) / (from * cosine + to * *beyond);
  return (parallel * parallel + across * across) / 2;
}

Vec3 reflected(const Vec3& to_viewer, const Normal3& normal) {
  return 2 * dot(normal, to_viewer) * as_vector(normal) - to_viewer;
}

Vec3 refracted(const Vec3& to_viewer, const Normal3& normal, const Interface& interface, double refracted_cosine) {
  const double ratio = interface.from / interface.to;
  return (ratio * interface.cosine - refracted_cosine) * as_vector(normal) - ratio * to_viewer;
}

}  // namespace plumb

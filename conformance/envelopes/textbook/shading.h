#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "conformance/envelopes/textbook/scene.h"
#include "conformance/envelopes/textbook/textbook.h"

namespace plumb::textbook {

/// Two media that meet: the cosine of the ray on its own side, and the refractive indices.
template <class A>
struct Interface {
  RealOf<A> cosine, from, to;

  /// The cosine on the far side by Snell's law; none under total internal reflection.
  std::optional<RealOf<A>> cosine_beyond() const {
    const RealOf<A> ratio = from / to;
    const RealOf<A> squared = 1 - ratio * ratio * (1 - cosine * cosine);
    if (!(squared >= 0)) return std::nullopt;
    return std::sqrt(squared);
  }
};

/// The share of unpolarised light that is reflected; `beyond` is the cosine on the far side.
template <class A>
RealOf<A> reflectance(const Interface<A>& at, RealOf<A> beyond, bool schlick, Formulas formulas) {
  using Real = RealOf<A>;
  const auto [c, from, to] = at;
  if (from == to) return 0;  // where nothing changes; at grazing incidence the formulas divide zero by zero
  if (schlick) {
    const Real r0 = (to - from) / (to + from);
    const Real rest = 1 - (from <= to ? c : beyond);
    return r0 * r0 + (1 - r0 * r0) * rest * rest * rest * rest * rest;
  }
  if (formulas == Formulas::other) {  // [Cook 1982]
    const Real g = to / from * beyond;
    const Real outer = (g - c) / (g + c);
    const Real inner = (c * (g + c) - 1) / (c * (g - c) + 1);
    return outer * outer * (1 + inner * inner) / 2;
  }
  const Real parallel = (to * c - from * beyond) / (to * c + from * beyond);
  const Real across = (from * c - to * beyond) / (from * c + to * beyond);
  return (parallel * parallel + across * across) / 2;
}

/// Follows rays and notes in a sample what they meet.
template <class A>
class Tracer {
  using Real = RealOf<A>;
  using V = Vector<A>;

 public:
  Tracer(const Scene<A>& scene, const TextbookOptions& options) : scene_(scene), options_(options) {}

  /// The sample that a camera ray, with a direction of any length, takes.
  TextbookSample sample(const V& origin, const V& direction) {
    sample_ = {};
    const V color = trace({origin, direction, 0, Bounds<A>::kInfinity}, {1, 1});
    sample_.color = {color.x, color.y, color.z};
    return sample_;
  }

 private:
  /// The ray's place in the tree of rays, and the product of its weights.
  struct Path {
    int depth;
    Real contribution;
  };

  /// All vectors of unit length; to_viewer against the ray.
  struct Point {
    V position, normal, to_viewer;
  };

  enum Note : std::uint32_t { kMissed = 1, kDropped, kReflected, kRefracted, kSurface, kLights };

  /// [Whitted 1980]
  V trace(const Ray<A>& ray, const Path& path) {
    const std::optional<Hit<A>> hit = scene_.closest(ray);
    if (!hit) {
      if (path.depth > 1) note(kMissed, 0);
      return {};
    }
    const Placement<A>& placed = scene_.placements[hit->placement];
    const Point point{scene_.position(ray, *hit), scene_.normal(ray, *hit), unit(-ray.direction)};
    const bool smooth = placed.is_mesh && !scene_.meshes[placed.shape].normals.empty();
    note_surface(hit->placement + 1, smooth ? 0 : hit->part, path.depth);
    const auto cosine = static_cast<float>(std::fabs(dot(point.normal, point.to_viewer)));
    sample_.grazing = std::min(sample_.grazing, cosine);
    return shade(scene_.shaders[placed.shader], point, path);
  }

  V shade(const Shader<A>& shader, const Point& point, const Path& path) {
    if (shader.coat == Coat::glazed) return shade_glazed(shader, point, path);
    if (shader.coat == Coat::glass) return shade_glass(shader, point, path);
    return shade_matt(shader, point, path);
  }

  /// Lambertian and Phong, by Blinn's half vector [Blinn 1977].
  V shade_matt(const Shader<A>& shader, const Point& point, const Path& path) {
    V color;
    std::uint32_t lit = 0;
    const std::size_t count = scene_.lights.size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t number = A::kReversed ? count - 1 - i : i;
      const Light<A>& light = scene_.lights[number];
      const V to_light = light.position - point.position;
      const V l = unit(to_light);
      const Real diffuse = std::max(Real(0), dot(point.normal, l));
      V scattered = diffuse * shader.diffuse;
      Real highlight = 0;
      if (shader.coat == Coat::phong) {
        highlight = std::pow(std::max(Real(0), dot(point.normal, unit(l + point.to_viewer))), shader.exponent);
        scattered = scattered + highlight * shader.specular;
      }
      if (!(diffuse > 0 || highlight > 0)) continue;
      if (scene_.blocks({point.position, to_light, static_cast<Real>(options_.t_min), 1})) continue;
      color = color + scattered * light.intensity;
      lit += mixed(0, static_cast<std::uint32_t>(number) + 1);  // a sum does not depend on the order
    }
    if (path.depth == 1) {
      sample_.shadows = lit;
    } else {
      note(kLights, lit);
    }
    return color;
  }

  V shade_glazed(const Shader<A>& shader, const Point& point, const Path& path) {
    const Interface<A> at{dot(point.normal, point.to_viewer), 1, shader.refractive_index};
    const Shader<A>& substrate = scene_.shaders[shader.substrate];
    if (!(at.cosine > 0)) return shade(substrate, point, path);
    const std::optional<Real> beyond = at.cosine_beyond();
    const Real r = beyond ? reflectance(at, *beyond, options_.schlick, scene_.formulas) : 1;
    const V below = shade(substrate, point, {path.depth, path.contribution * (1 - r)});
    return (1 - r) * below + r * follow(kReflected, point, mirrored(point, point.normal), path, r);
  }

  V shade_glass(const Shader<A>& shader, const Point& point, const Path& path) {
    const Real facing = dot(point.normal, point.to_viewer);
    const bool inside = facing < 0;
    const V normal = inside ? -point.normal : point.normal;
    const Interface<A> at =
        inside ? Interface<A>{-facing, shader.refractive_index, 1} : Interface<A>{facing, 1, shader.refractive_index};
    const std::optional<Real> beyond = at.cosine_beyond();
    const V mirror = mirrored(point, normal);
    if (!beyond) return follow(kReflected, point, mirror, path, 1);
    const Real r = reflectance(at, *beyond, options_.schlick, scene_.formulas);
    const Real ratio = at.from / at.to;
    const V through = scene_.formulas == Formulas::usual
                          ? (ratio * at.cosine - *beyond) * normal - ratio * point.to_viewer
                          : ratio * (at.cosine * normal - point.to_viewer) - *beyond * normal;
    const V reflected = r * follow(kReflected, point, mirror, path, r);
    return reflected + (1 - r) * follow(kRefracted, point, through, path, 1 - r);
  }

  static V mirrored(const Point& point, const V& normal) {
    return 2 * dot(normal, point.to_viewer) * normal - point.to_viewer;
  }

  V follow(Note kind, const Point& from, const V& direction, const Path& path, Real weight) {
    note(kind, static_cast<std::uint32_t>(path.depth));
    const Path next{path.depth + 1, path.contribution * weight};
    if (next.depth > options_.max_depth || next.contribution < static_cast<Real>(options_.min_contribution)) {
      note(kDropped, 0);
      return {};
    }
    return trace({from.position, direction, static_cast<Real>(options_.t_min), Bounds<A>::kInfinity}, next);
  }

  void note_surface(std::uint32_t surface, std::uint32_t face, int depth) {
    if (depth == 1) {
      sample_.primary = surface, sample_.face = face;
    } else {
      note(kSurface, mixed(surface, face));
    }
  }
  void note(Note what, std::uint32_t value) { sample_.path = mixed(mixed(sample_.path, what), value); }

  /// A hash of both by multiplication; it depends on their order.
  static std::uint32_t mixed(std::uint32_t hash, std::uint32_t value) {
    const std::uint64_t bits = (0xcbf29ce484222325 ^ (std::uint64_t{hash} << 32 | value)) * 0x9e3779b97f4a7c15;
    return static_cast<std::uint32_t>(bits >> 32 ^ bits >> 7);
  }

  const Scene<A>& scene_;
  const TextbookOptions& options_;
  TextbookSample sample_;
};

}  // namespace plumb::textbook

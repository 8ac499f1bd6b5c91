#include "conformance/envelopes/make_envelope.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/build_scene.h"
#include "renderer/film/render.h"
#include "renderer/image/image.h"

namespace plumb {
namespace {

/// What all that was rendered saw of one sample.
struct SampleHull {
  Color low, high;
  TextbookSample first;
  PixelReason reason = PixelReason::interior;
};

void include(SampleHull& hull, const Color& c) {
  hull.low = {std::min(hull.low.r, c.r), std::min(hull.low.g, c.g), std::min(hull.low.b, c.b)};
  hull.high = {std::max(hull.high.r, c.r), std::max(hull.high.g, c.g), std::max(hull.high.b, c.b)};
}

/// The reason that stands nearest to the eye is the one to name.
PixelReason nearer(PixelReason a, PixelReason b) {
  if (a == PixelReason::interior) return b;
  if (b == PixelReason::interior) return a;
  return std::min(a, b);
}

PixelReason difference(const TextbookSample& a, const TextbookSample& b) {
  if (a.primary != b.primary || a.face != b.face) return PixelReason::silhouette;
  if (a.shadows != b.shadows) return PixelReason::shadow_edge;
  if (a.path != b.path) return PixelReason::reflection;
  return PixelReason::interior;
}

double level(double linear) { return 255 * std::pow(std::clamp(linear, 0.0, 1.0), 1 / 2.2); }

bool is_grazing(const Color& low, const Color& high) {
  return level(high.r) - level(low.r) > kGrazingLevels || level(high.g) - level(low.g) > kGrazingLevels ||
         level(high.b) - level(low.b) > kGrazingLevels;
}

BuildOptions options_of(const Variant& variant, int grid, int threads) {
  BuildOptions build;
  build.fresnel = variant.fresnel;
  build.threads = threads;
  build.overrides.samples = grid * grid;
  if (!variant.cutoff) build.overrides.min_contribution = 0;
  return build;
}

/// All samples of one pixel, at most N x N of them, to its interval.
void settle_pixel(std::span<const SampleHull> samples, const Color& reference, std::size_t pixel, Envelope& envelope) {
  Color low, high;
  PixelReason reason = PixelReason::interior;
  for (const SampleHull& s : samples) {
    low += s.low, high += s.high;
    reason = nearer(reason, s.reason);
  }
  const double share = 1.0 / static_cast<double>(samples.size());
  low = share * low, high = share * high;
  if (reason == PixelReason::interior && is_grazing(low, high)) reason = PixelReason::grazing;
  const std::array<double, 3> lows{low.r, low.g, low.b}, highs{high.r, high.g, high.b},
      middle{reference.r, reference.g, reference.b};
  for (std::size_t c = 0; c < 3; ++c) {
    const double widest = std::max(highs[c], middle[c]) * kColorError;
    envelope.nominal[3 * pixel + c] = level_of(middle[c]);
    envelope.low[3 * pixel + c] = level_of(std::min(lows[c], middle[c]) - widest);
    envelope.high[3 * pixel + c] = level_of(std::max(highs[c], middle[c]) + widest);
  }
  envelope.reasons[pixel] = reason;
}

bool has_dielectric(const ObjectDescription& object) {
  if (object.kind->name == "Glass" || object.kind->name == "Glazed") return true;
  for (const Property& p : object.properties)
    if (const auto* inner = std::get_if<ObjectPointer>(&p.value); inner && *inner && has_dielectric(**inner))
      return true;
  return false;
}

}  // namespace

std::span<const Perturbation> perturbations() {
  static const std::vector<Perturbation> kList = [] {
    // An edge that lies within a thousandth of a pixel of a sample may fall to either side: a float program's rays and
    // hits are off by some 2^-24 of the scene's size, a few times 1e-5 of a pixel.
    constexpr double kShift = 1e-3;
    // Vertices, centres and radii as they are after a handful of roundings to single precision.
    constexpr double kNoise = 0x1p-22;
    return std::vector<Perturbation>{
        {"double", {}},
        {"double, t_min 1e-9", {.t_min = 1e-9}},
        {"double, t_min 1e-4", {.t_min = 1e-4}},
        {"float, t_min 1e-5", {.single = true, .t_min = 1e-5}},
        {"float, t_min 1e-4", {.single = true, .t_min = 1e-4}},
        {"double, sums in the other order", {.reverse_sums = true}},
        {"double, other formulas", {.other_formulas = true}},
        {"float, sums in the other order", {.single = true, .t_min = 1e-4, .reverse_sums = true}},
        {"rays to the right", {.shift_x = kShift}},
        {"rays to the left", {.shift_x = -kShift}},
        {"rays upwards", {.shift_y = kShift}},
        {"rays downwards", {.shift_y = -kShift}},
        {"vertices", {.vertex_noise = kNoise}},
    };
  }();
  return kList;
}

bool same_for(const SceneDescription& description, const Variant& a, const Variant& b) {
  const int samples = description.scene->integer("samples");
  if (grid_side(samples, a.samples) != grid_side(samples, b.samples)) return false;
  return (a.cutoff == b.cutoff && a.fresnel == b.fresnel) || !has_dielectric(*description.scene);
}

Envelope make_envelope(const EnvelopeRequest& request) {
  std::vector<std::string> warnings;
  const int grid = grid_side(request.description.scene->integer("samples"), request.variant.samples);
  const Scene scene =
      build_scene(request.description, request.meshes, options_of(request.variant, grid, request.threads), warnings);
  const Image reference = render(scene, {.threads = request.threads, .crop = {}, .progress = {}}).image;

  std::vector<SampleHull> hulls;
  const std::span<const Perturbation> list = perturbations();
  for (std::size_t k = 0; k < list.size(); ++k) {
    TextbookOptions options = list[k].options;
    options.grid = grid;
    options.width = reference.width(), options.height = reference.height();
    options.max_depth = scene.max_depth();
    options.min_contribution = scene.min_contribution();
    options.schlick = request.variant.fresnel == Fresnel::schlick;
    const std::vector<TextbookSample> samples =
        textbook_samples(request.description, request.meshes, options, request.threads);
    if (k == 0) {
      hulls.reserve(samples.size());
      for (const TextbookSample& s : samples) hulls.push_back({s.color, s.color, s, PixelReason::interior});
    }
    for (std::size_t i = 0; i < samples.size(); ++i) {
      include(hulls[i], samples[i].color);
      hulls[i].reason = nearer(hulls[i].reason, difference(hulls[i].first, samples[i]));
    }
    request.progress(static_cast<double>(k + 1) / static_cast<double>(list.size()));
  }

  Envelope envelope;
  envelope.width = reference.width(), envelope.height = reference.height();
  const std::size_t pixels = reference.pixels().size();
  envelope.nominal.resize(3 * pixels), envelope.low.resize(3 * pixels), envelope.high.resize(3 * pixels);
  envelope.reasons.resize(pixels);
  const auto samples = static_cast<std::size_t>(grid * grid);
  for (std::size_t p = 0; p < pixels; ++p)
    settle_pixel(std::span(hulls).subspan(p * samples, samples), reference.pixels()[p], p, envelope);
  return envelope;
}

}  // namespace plumb

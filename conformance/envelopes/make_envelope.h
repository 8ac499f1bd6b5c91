#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "conformance/envelopes/envelope.h"
#include "conformance/envelopes/textbook/textbook.h"
#include "conformance/envelopes/variant.h"
#include "renderer/scene.h"
#include "scenes/load_meshes.h"
#include "scenes/scene_description.h"

namespace plumb {

/// One way in which a correct program may differ from the reference: each is applied alone.
struct Perturbation {
  std::string_view what;
  /// Precision, offsets, order and formulas; what belongs to the scene and the variant is filled in.
  TextbookOptions options;
};

/// The written list (docs/envelopes.md): each entry is by itself a correct program, free of acne.
std::span<const Perturbation> perturbations();

struct EnvelopeRequest {
  const SceneDescription& description;
  const MeshTable& meshes;
  Variant variant;
  /// 0 for as many as there are processors. The result does not depend on it.
  int threads = 0;
  /// Told the share that is done.
  std::function<void(double)> progress = [](double) {};
};

/// Renders the scene by the reference and by every perturbation, and takes for each sample and channel the hull of what
/// they saw, widened by kColorError of its larger end; a pixel's interval is the mean of its samples' (they may fall to
/// either side independently of each other), rounded to levels. A pixel's reason is the first that any of its samples
/// gives: primary surface, shadows, path, or a hull wider than kGrazingLevels levels. Throws what build_scene throws.
Envelope make_envelope(const EnvelopeRequest& request);

/// A float program of a thousand roundings a sample, each of 2^-24 relative to the colour, adding up at random
/// (sqrt(1000) 2^-24 < 2^-19), with a factor of two for their correlation.
constexpr double kColorError = 0x1p-18;
/// A hull that the rounding of one level and a tolerance of one more would not cover.
constexpr double kGrazingLevels = 2;

/// What decides whether two variants are the same one for a scene: grid, and, with dielectrics, cutoff and Fresnel.
bool same_for(const SceneDescription& description, const Variant& a, const Variant& b);

}  // namespace plumb

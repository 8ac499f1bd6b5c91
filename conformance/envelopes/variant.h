#pragma once

#include <string>
#include <string_view>

#include "renderer/shaders/fresnel.h"

namespace plumb {

/// How a number of samples that is no square becomes an N x N grid.
enum class SampleRounding { nearest, up, down };

/// One of the ways to read an assignment that a suite accepts. A submission must keep to one in all cases.
struct Variant {
  std::string id = "course";
  SampleRounding samples = SampleRounding::nearest;
  /// Whether rays that count for less than the scene's minimum contribution are dropped.
  bool cutoff = true;
  Fresnel fresnel = Fresnel::exact;
  friend bool operator==(const Variant&, const Variant&) = default;
};

/// The N of the N x N grid; at least 1. `samples` is the scene's number.
int grid_side(int samples, SampleRounding rounding);

}  // namespace plumb

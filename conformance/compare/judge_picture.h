#pragma once

#include <filesystem>
#include <optional>

#include "conformance/compare/picture_difference.h"
#include "conformance/verdict.h"
#include "renderer/image/picture.h"

namespace plumb {

/// A picture's verdict, with what led to it as far as it was found.
struct PictureJudgement {
  CheckResult result;
  /// There once the picture could be decoded.
  std::optional<Picture> picture;
  /// There once it could be compared.
  std::optional<PictureDifference> difference;
};

/// Judges a picture file against a reference, in this order: signature and header (`bad_picture`; also where one of the
/// two is linear and the other is not), size (`wrong_size`; before decoding, so that no picture takes more memory than
/// the reference's size), decoding (`bad_picture`), finiteness (`not_finite`), then the largest channel difference
/// against `tolerance` (`different`): levels for PNG and PPM, linear values for EXR. A right picture with transparent
/// pixels is a quality_warning (`transparent`).
///
/// Throws InputError if the picture does not exist.
PictureJudgement judge_picture(const std::filesystem::path& picture, const Picture& reference, double tolerance);

/// The steps of judge_picture before the comparison: a picture that can be compared with the reference has no verdict
/// against it yet (`pass`), any other none to be compared.
PictureJudgement open_picture(const std::filesystem::path& picture, const Picture& reference);

/// Reads a picture that is to be trusted as a reference. Throws InputError if it is missing, invalid or not finite.
Picture read_reference(const std::filesystem::path& file);

}  // namespace plumb

#include "conformance/compare/judge_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "renderer/image/picture_header.h"
#include "renderer/image/read_picture.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

CheckResult fault(const std::string& cause, const std::string& summary, const std::string& advice) {
  CheckResult result;
  result.verdict = Verdict::fail;
  result.cause = cause;
  result.summary = summary;
  result.advice = advice;
  return result;
}

std::optional<std::size_t> first_not_finite(const Picture& picture) {
  const auto found = std::ranges::find_if_not(picture.samples, [](float v) { return std::isfinite(v); });
  if (found == picture.samples.end()) return std::nullopt;
  return static_cast<std::size_t>(found - picture.samples.begin()) / 3;
}

std::string color_text(const Picture& picture, int x, int y) {
  const float* p = picture.pixel(x, y);
  return fmt::format("{:.6g} {:.6g} {:.6g}", p[0], p[1], p[2]);
}

CheckResult judge_difference(const Picture& reference, const Picture& picture, const PictureDifference& d,
                             double tolerance) {
  const std::string unit = reference.is_linear() ? "" : tolerance == 1 ? " level" : " levels";
  CheckResult result;
  result.margin = tolerance - d.max;
  result.evidence = {{"pixels", d.pixels},
                     {"pixels_past_tolerance", d.pixels_past},
                     {"tolerance", tolerance},
                     {"max_difference", d.max}};
  if (d.max > 0) {
    result.evidence.insert(result.evidence.end(), {{"max_x", std::int64_t{d.max_x}},
                                                   {"max_y", std::int64_t{d.max_y}},
                                                   {"expected", color_text(reference, d.max_x, d.max_y)},
                                                   {"found", color_text(picture, d.max_x, d.max_y)}});
  }
  if (d.pixels_past > 0) {
    result.verdict = Verdict::fail;
    result.cause = "different";
    result.summary = fmt::format("{} of {} pixels differ by more than {:g}{}, the most by {:.6g}", d.pixels_past,
                                 d.pixels, tolerance, unit, d.max);
    result.advice = fmt::format("look at pixel ({},{}): expected {}, found {}", d.max_x, d.max_y,
                                color_text(reference, d.max_x, d.max_y), color_text(picture, d.max_x, d.max_y));
    return result;
  }
  result.verdict = picture.transparent ? Verdict::quality_warning : Verdict::pass;
  result.summary = d.max == 0 ? fmt::format("all {} pixels equal", d.pixels)
                              : fmt::format("largest difference {:.6g}, within {:g}{}", d.max, tolerance, unit);
  if (picture.transparent) {
    result.cause = "transparent";
    result.advice = "the colours are right, but some pixels are transparent: write an opaque picture";
  }
  return result;
}

}  // namespace

PictureJudgement open_picture(const std::filesystem::path& file, const Picture& reference) {
  PictureJudgement judgement;
  try {
    const PictureHeader header = read_picture_header(file);
    if ((header.format == PictureFormat::exr) != reference.is_linear()) {
      throw BadPicture(to_string(header.format) + " cannot be compared with a reference in " +
                       to_string(reference.format) + ", expected both linear (EXR) or both in 8-bit levels (PNG, PPM)");
    }
    if (header.width != reference.width || header.height != reference.height) {
      judgement.result = fault("wrong_size",
                               fmt::format("the picture is {}x{}, expected {}x{}", header.width, header.height,
                                           reference.width, reference.height),
                               "write the picture in the size that the scene asks for");
      judgement.result.evidence = {{"width", std::int64_t{header.width}},
                                   {"height", std::int64_t{header.height}},
                                   {"expected_width", std::int64_t{reference.width}},
                                   {"expected_height", std::int64_t{reference.height}}};
      return judgement;
    }
    judgement.picture = read_picture(file);
  } catch (const BadPicture& error) {
    judgement.result = fault("bad_picture", std::string("the picture cannot be used: ") + error.what(),
                             "write a valid picture file of the kind its name says");
    return judgement;
  }
  const Picture& picture = *judgement.picture;
  if (const auto pixel = first_not_finite(picture)) {
    const auto width = static_cast<std::size_t>(picture.width);
    judgement.result =
        fault("not_finite", fmt::format("pixel ({},{}) is not a finite number", *pixel % width, *pixel / width),
              "look for a division by zero or a square root of a negative number");
    judgement.result.evidence = {{"x", static_cast<std::int64_t>(*pixel % width)},
                                 {"y", static_cast<std::int64_t>(*pixel / width)}};
    return judgement;
  }
  judgement.result.verdict = Verdict::pass;
  return judgement;
}

PictureJudgement judge_picture(const std::filesystem::path& file, const Picture& reference, double tolerance) {
  PictureJudgement judgement = open_picture(file, reference);
  if (judgement.result.verdict != Verdict::pass) return judgement;
  judgement.difference = difference(reference, *judgement.picture, tolerance);
  judgement.result = judge_difference(reference, *judgement.picture, *judgement.difference, tolerance);
  return judgement;
}

Picture read_reference(const std::filesystem::path& file) {
  try {
    Picture reference = read_picture(file);
    if (first_not_finite(reference)) throw BadPicture("a pixel is not a finite number");
    return reference;
  } catch (const BadPicture& error) {
    throw InputError({file.string()}, std::string("the reference picture cannot be used: ") + error.what());
  }
}

}  // namespace plumb

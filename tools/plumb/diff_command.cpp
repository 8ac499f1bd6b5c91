#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "conformance/compare/flip.h"
#include "conformance/compare/heat_map.h"
#include "conformance/compare/judge_picture.h"
#include "conformance/compare/picture_faults.h"
#include "conformance/compare/wrong_regions.h"
#include "renderer/image/picture_header.h"
#include "renderer/image/read_picture.h"
#include "renderer/image/write_image.h"
#include "renderer/math/input_error.h"
#include "renderer/math/nearest_name.h"
#include "tools/plumb/command.h"

namespace plumb {
namespace {

struct Arguments {
  std::string picture;
  std::string reference;
  double tolerance = 0;
  std::string out;
  std::string flip;
  bool json = false;
};

/// What else is said of two pictures in 8-bit levels that differ.
struct Explanation {
  std::optional<FlipErrors> flip;
  WrongRegions regions;
  std::vector<FoundFault> faults;
};

Explanation explain(const Picture& reference, const PictureJudgement& judgement, const Arguments& arguments) {
  Explanation explanation;
  if (reference.is_linear()) return explanation;
  if (judgement.difference && judgement.difference->max > 0) {
    explanation.flip = flip(reference, *judgement.picture);
    explanation.regions = wrong_regions(wrong_pixels(reference, *judgement.picture, arguments.tolerance));
    explanation.faults = picture_faults(reference, *judgement.picture, arguments.tolerance);
  } else if (judgement.result.cause == "wrong_size") {
    // Decoded only where the sides are exchanged, so that no picture takes more memory than the reference.
    const PictureHeader header = read_picture_header(arguments.picture);
    if (header.width != reference.height || header.height != reference.width) return explanation;
    try {
      explanation.faults = picture_faults(reference, read_picture(arguments.picture), arguments.tolerance);
    } catch (const BadPicture&) {
      // It is wrong already; what is in it will not be known.
    }
  }
  return explanation;
}

constexpr std::array<const char*, 3> kChannels{"red", "green", "blue"};

void print_explanation(const Explanation& explanation) {
  if (explanation.flip) {
    const FlipErrors& flip = *explanation.flip;
    fmt::print("  FLIP: mean {:.6f}, p99 {:.6f}, max {:.6f}\n", flip.mean, flip.p99, flip.max);
  }
  if (explanation.regions.wrong > 0) {
    const auto& [wrong, blobs, blob, window] = explanation.regions;
    fmt::print("  wrong pixels: {} {}, the largest of {} within {}x{} at ({},{}); most in {}x{} at ({},{}): {}\n",
               blobs, blobs == 1 ? "blob" : "blobs", blob.wrong, blob.width, blob.height, blob.x, blob.y, window.width,
               window.height, window.x, window.y, window.wrong);
  }
  for (const FoundFault& fault : explanation.faults)
    fmt::print("  {}: {} (explains {:.0f} %)\n", to_string(fault.fault), fault.sentence, 100 * fault.explained);
}

void print_text(const PictureJudgement& judgement, const Explanation& explanation, const Arguments& arguments) {
  const CheckResult& result = judgement.result;
  fmt::print("{}: {}\n", is_right(result.verdict) ? "same" : "different", result.summary);
  if (!result.advice.empty()) fmt::print("  {}\n", result.advice);
  if (!judgement.difference) return print_explanation(explanation);
  fmt::print("  {:<8}{:>12}{:>12}{:>12}{:>16}\n", "channel", "max", "mean", "rms",
             fmt::format("share > {:g}", arguments.tolerance));
  for (std::size_t c = 0; c < 3; ++c) {
    const ChannelDifference& d = judgement.difference->channels[c];
    fmt::print("  {:<8}{:>12.6g}{:>12.6g}{:>12.6g}{:>16.6g}\n", kChannels[c], d.max, d.mean, d.rms, d.share_past);
  }
  print_explanation(explanation);
}

nlohmann::ordered_json to_json(const WrongRegion& region) {
  return {
      {"x", region.x}, {"y", region.y}, {"width", region.width}, {"height", region.height}, {"wrong", region.wrong}};
}

void add_explanation(const Explanation& explanation, nlohmann::ordered_json& json) {
  if (explanation.flip) {
    json["flip"] = {{"mean", explanation.flip->mean}, {"p99", explanation.flip->p99}, {"max", explanation.flip->max}};
    json["blobs"] = explanation.regions.blobs;
  }
  if (explanation.regions.wrong > 0) {
    json["largest_blob"] = to_json(explanation.regions.largest_blob);
    json["densest_window"] = to_json(explanation.regions.densest_window);
  }
  for (const FoundFault& fault : explanation.faults)
    json["faults"].push_back(
        {{"name", to_string(fault.fault)}, {"sentence", fault.sentence}, {"explained", fault.explained}});
}

void print_json(const PictureJudgement& judgement, const Explanation& explanation, const Arguments& arguments) {
  const CheckResult& result = judgement.result;
  nlohmann::ordered_json json{
      {"schema", 1},
      {"verdict", to_string(result.verdict)},
      {"cause", result.cause},
      {"summary", result.summary},
      {"tolerance", arguments.tolerance},
      {"margin", result.margin ? nlohmann::ordered_json(*result.margin) : nlohmann::ordered_json()}};
  if (judgement.difference) {
    const PictureDifference& d = *judgement.difference;
    json["pixels"] = d.pixels;
    json["pixels_past_tolerance"] = d.pixels_past;
    json["max"] = d.max;
    json["max_at"] = {d.max_x, d.max_y};
    for (std::size_t c = 0; c < 3; ++c) {
      const ChannelDifference& channel = d.channels[c];
      json["channels"][kChannels[c]] = {{"max", channel.max},
                                        {"mean", channel.mean},
                                        {"rms", channel.rms},
                                        {"share_past_tolerance", channel.share_past}};
    }
  }
  add_explanation(explanation, json);
  fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

/// A reference that is invalid is as wrong an answer as an invalid picture: exit status 1, not a usage error.
std::optional<PictureJudgement> judge_reference(const std::string& file) {
  try {
    read_picture_header(file);
    const Picture picture = read_picture(file);
    PictureJudgement judgement = judge_picture(file, picture, 0);
    if (!is_right(judgement.result.verdict)) return judgement;
  } catch (const BadPicture& error) {
    PictureJudgement judgement;
    judgement.result.verdict = Verdict::fail;
    judgement.result.cause = "bad_picture";
    judgement.result.summary = fmt::format("the reference cannot be used: {}", error.what());
    return judgement;
  }
  return std::nullopt;
}

/// CLI11's form of a check: what is wrong, or nothing.
std::string parse_tolerance(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool good = error == std::errc{} && end == text.data() + text.size() && std::isfinite(value) && value >= 0;
  return good ? "" : "'" + text + "' is no tolerance, expected a number of at least 0";
}

/// Before any work: a map that could not be written.
void require_map_writable(const std::string& file, const char* what) {
  if (file.empty()) return;
  if (!equal_ignoring_case(std::filesystem::path(file).extension().string(), ".png"))
    throw InputError({file}, fmt::format("the {} is a PNG picture, expected a name that ends in .png", what));
  require_image_writable(file);
}

void write_maps(const Picture& reference, const PictureJudgement& judgement, const Explanation& explanation,
                const Arguments& arguments) {
  const int width = reference.width, height = reference.height;
  if (!arguments.out.empty()) write_png(heat_map(reference, *judgement.picture), width, height, arguments.out);
  if (arguments.flip.empty()) return;
  const FlipErrors errors = explanation.flip ? *explanation.flip : flip(reference, *judgement.picture);
  write_png(flip_map(errors), width, height, arguments.flip);
}

int run(const Arguments& arguments) {
  require_map_writable(arguments.out, "heat map");
  require_map_writable(arguments.flip, "map of FLIP");
  PictureJudgement judgement;
  Explanation explanation;
  if (auto bad_reference = judge_reference(arguments.reference)) {
    judgement = std::move(*bad_reference);
  } else {
    const Picture reference = read_reference(arguments.reference);
    if (!arguments.flip.empty() && reference.is_linear())
      throw InputError({arguments.reference}, "FLIP is defined for 8-bit levels, expected PNG or PPM with --flip");
    judgement = judge_picture(arguments.picture, reference, arguments.tolerance);
    explanation = explain(reference, judgement, arguments);
    if (judgement.difference) write_maps(reference, judgement, explanation, arguments);
  }
  arguments.json ? print_json(judgement, explanation, arguments) : print_text(judgement, explanation, arguments);
  return exit_status({&judgement.result.verdict, 1});
}

}  // namespace

void add_diff_command(CLI::App& app, Action& action) {
  // CLI11's own check lets NaN pass, against which nothing is different.
  const CLI::Validator not_negative([](std::string& text) { return parse_tolerance(text); }, "NUMBER >= 0",
                                    "tolerance");
  CLI::App* command =
      app.add_subcommand("diff", "Compare two pictures (PNG, EXR, PPM): exit status 0 if they are the same");
  const auto arguments = std::make_shared<Arguments>();
  Arguments& a = *arguments;
  command->add_option("picture", a.picture, "The picture to judge")->required()->type_name("A");
  command->add_option("reference", a.reference, "The picture it should be")->required()->type_name("B");
  command
      ->add_option("--tolerance", a.tolerance,
                   "Largest channel difference that counts as the same: 8-bit levels, or linear for EXR")
      ->check(not_negative)
      ->capture_default_str();
  command->add_option("--out", a.out, "Write an amplified heat map of the difference")->type_name("FILE.png");
  command->add_option("--flip", a.flip, "Write a map of how visible the difference is (PNG and PPM)")
      ->type_name("FILE.png");
  command->add_flag("--json", a.json, "Print the result as JSON");
  command->callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace plumb

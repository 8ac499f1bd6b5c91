#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "conformance/compare/heat_map.h"
#include "conformance/compare/judge_picture.h"
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
  bool json = false;
};

constexpr std::array<const char*, 3> kChannels{"red", "green", "blue"};

void print_text(const PictureJudgement& judgement, const Arguments& arguments) {
  const CheckResult& result = judgement.result;
  fmt::print("{}: {}\n", is_right(result.verdict) ? "same" : "different", result.summary);
  if (!result.advice.empty()) fmt::print("  {}\n", result.advice);
  if (!judgement.difference) return;
  fmt::print("  {:<8}{:>12}{:>12}{:>12}{:>16}\n", "channel", "max", "mean", "rms",
             fmt::format("share > {:g}", arguments.tolerance));
  for (std::size_t c = 0; c < 3; ++c) {
    const ChannelDifference& d = judgement.difference->channels[c];
    fmt::print("  {:<8}{:>12.6g}{:>12.6g}{:>12.6g}{:>16.6g}\n", kChannels[c], d.max, d.mean, d.rms, d.share_past);
  }
}

void print_json(const PictureJudgement& judgement, const Arguments& arguments) {
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

int run(const Arguments& arguments) {
  if (!arguments.out.empty() && !equal_ignoring_case(std::filesystem::path(arguments.out).extension().string(), ".png"))
    throw InputError({arguments.out}, "the heat map is a PNG picture, expected a name that ends in .png");
  if (!arguments.out.empty()) require_image_writable(arguments.out);
  PictureJudgement judgement;
  if (auto bad_reference = judge_reference(arguments.reference)) {
    judgement = std::move(*bad_reference);
  } else {
    const Picture reference = read_reference(arguments.reference);
    judgement = judge_picture(arguments.picture, reference, arguments.tolerance);
    if (!arguments.out.empty() && judgement.difference) {
      write_png(heat_map(reference, *judgement.picture), reference.width, reference.height, arguments.out);
    }
  }
  arguments.json ? print_json(judgement, arguments) : print_text(judgement, arguments);
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
  command->add_flag("--json", a.json, "Print the result as JSON");
  command->callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace plumb

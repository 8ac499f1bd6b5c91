#include "conformance/judge/runner_rules.h"

#include <array>
#include <span>

#include "conformance/judge/toml_fields.h"
#include "renderer/math/nearest_name.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 6> kRenderNames{"scene", "scene_name", "folder", "output", "width", "height"};
constexpr std::array<std::string_view, 3> kOutputNames{"scene", "scene_name", "folder"};
constexpr std::array<std::string_view, 1> kBuildNames{"sources:GLOB"};
constexpr std::string_view kSources = "{sources:";

/// Braces that enclose a single word are placeholders; any other brace stands for itself.
void check_placeholders(const TomlFields& fields, std::string_view key, std::string_view text,
                        std::span<const std::string_view> names) {
  for (std::size_t open = text.find('{'); open != std::string_view::npos; open = text.find('{', open + 1)) {
    const std::size_t close = text.find('}', open);
    if (close == std::string_view::npos) return;
    const std::string_view name = text.substr(open + 1, close - open - 1);
    if (name.empty() || name.find_first_of(" \t\"'{") != std::string_view::npos) continue;
    bool known = false;
    std::string expected;
    for (const std::string_view candidate : names) {
      known = known || candidate == name;
      expected += (expected.empty() ? "{" : ", {") + std::string(candidate) + "}";
    }
    if (!known)
      fields.fail(key, "holds '{" + std::string(name) + "}', which stands for nothing here; expected " + expected +
                           did_you_mean(name, names));
  }
}

void check_build(const TomlFields& fields, const std::vector<std::string>& command) {
  if (command.empty() || command.front().empty())
    fields.fail("build", "holds an empty command, expected [\"program\", \"argument\"]");
  for (const std::string& argument : command) {
    if (argument.starts_with(kSources) && argument.ends_with('}')) continue;
    if (argument.find(kSources) != std::string::npos)
      fields.fail("build", "holds '" + argument + "', expected {sources:GLOB} as an argument of its own");
    check_placeholders(fields, "build", argument, kBuildNames);
  }
}

}  // namespace

Runner read_runner_fields(TomlFields& fields) {
  Runner runner;
  runner.build = fields.text_lists("build");
  for (const auto& command : runner.build) check_build(fields, command);
  runner.probe = fields.texts("probe");
  if (fields.has("probe") && (runner.probe.empty() || runner.probe.front().empty()))
    fields.fail("probe", "is empty, expected [\"program\", \"argument\"]");
  runner.kernel = fields.text("kernel", "");
  if (fields.has("kernel")) require_inner_path(fields, "kernel", runner.kernel);
  if (fields.has("kernel") && fields.has("probe")) fields.fail("kernel", "stands beside 'probe', expected one of them");
  // What only answers checks renders nothing.
  const bool answers = fields.has("probe") || fields.has("kernel");
  runner.render = fields.texts("render");
  if (fields.has("render") ? runner.render.empty() || runner.render.front().empty() : !answers)
    fields.fail("render", "is missing or empty, expected [\"program\", \"{scene}\"]" + fields.near_key("render"));
  for (const std::string& argument : runner.render) check_placeholders(fields, "render", argument, kRenderNames);
  runner.env = fields.text_table("env");
  runner.output = fields.text("output", runner.output);
  check_placeholders(fields, "output", runner.output, kOutputNames);
  require_inner_path(fields, "output", runner.output);
  const std::string ending = fs::path(runner.output).extension().string();
  if (ending != ".png" && ending != ".exr" && ending != ".ppm")
    fields.fail("output", "is '" + runner.output + "', expected a picture: .png, .exr or .ppm");
  runner.scene_at = fields.text("scene_at", "");
  if (!runner.scene_at.empty()) require_inner_path(fields, "scene_at", runner.scene_at);
  return runner;
}

void require_inner_path(const TomlFields& fields, std::string_view key, const std::string& path) {
  const fs::path p(path);
  if (path.empty() || p.is_absolute()) fields.fail(key, "is '" + path + "', expected a relative path");
  for (const fs::path& part : p)
    if (part == "..") fields.fail(key, "is '" + path + "', expected a path that stays inside the folder");
}

}  // namespace plumb

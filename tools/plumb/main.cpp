#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/math/input_error.h"
#include "renderer/math/nearest_name.h"
#include "tools/plumb/arguments.h"
#include "tools/plumb/command.h"

namespace {

/// 0 right, 1 wrong, 2 usage or bad input, 3 our own fault (docs/results.md).
constexpr int kUsage = 2;
constexpr int kInternal = 3;

/// A misspelt verb is named, before the parser only says that one is missing.
void check_verb(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string_view> verbs;
  for (const CLI::App* verb : app.get_subcommands(nullptr)) verbs.push_back(verb->get_name());
  if (std::ranges::find(verbs, argv[1]) != verbs.end()) return;
  throw plumb::InputError({}, std::string("plumb: unknown verb '") + argv[1] + "', expected " + plumb::joined(verbs) +
                                  plumb::did_you_mean(argv[1], verbs));
}

/// Takes `--probe COMMAND ...` off the end of the arguments of `plumb check`: the rest of the line is somebody else's.
std::vector<std::string> take_probe_command(int& argc, char** argv) {
  if (argc < 2 || std::string_view(argv[1]) != "check") return {};
  char** const end = argv + argc;
  char** const option = std::find(argv + 2, end, std::string_view("--probe"));
  if (option == end) return {};
  if (option + 1 == end) throw plumb::InputError({}, "--probe: expected a command after it");
  argc = static_cast<int>(option - argv);
  return {option + 1, end};
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Plumbline: is a ray tracer right, how wrong is it, why, and how fast.", "plumb");
  app.set_version_flag("--version", PLUMB_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(38);
  plumb::Action action;
  plumb::add_render_command(app, action);
  plumb::add_diff_command(app, action);
  plumb::add_grade_command(app, action);
  plumb::add_oracle_command(app, action);
  plumb::add_corpus_command(app, action);
  plumb::add_probe_command(app, action);
  plumb::add_growth_command(app, action);
  plumb::add_suite_command(app, action);
  plumb::add_mesh_command(app, action);
  try {
    plumb::add_check_command(app, action, take_probe_command(argc, argv));
    check_verb(app, argc, argv);
    app.parse(argc, argv);
    return action();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kUsage;
  } catch (const plumb::InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return kUsage;
  } catch (const std::exception& error) {
    fmt::print(stderr, "plumb: internal error: {}\n", error.what());
    return kInternal;
  }
}

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "renderer/math/input_error.h"
#include "tools/plumb/command.h"

namespace {

/// 0 right, 1 wrong, 2 usage or bad input, 3 our own fault (docs/results.md).
constexpr int kUsage = 2;
constexpr int kInternal = 3;

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
  try {
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

// The main program of a known bug: plumb's tracer, and of its verbs those that grading needs.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "renderer/math/input_error.h"
#include "tools/plumb/command.h"

int main(int argc, char** argv) {
  CLI::App app("Plumbline's tracer with a mistake planted in it.");
  app.require_subcommand(1);
  plumb::Action action;
  plumb::add_render_command(app, action);
  plumb::add_probe_command(app, action);
  try {
    app.parse(argc, argv);
    return action();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const plumb::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "internal error: %s\n", error.what());
    return 3;
  }
}

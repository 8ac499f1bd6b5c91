#pragma once

#include "tools/plumb/command.h"

namespace plumb {

/// Adds `score` to the verb `suite`.
void add_suite_score_command(CLI::App& suite, Action& action);

}  // namespace plumb

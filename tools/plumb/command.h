#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace plumb {

/// What the chosen verb does; returns the exit status.
using Action = std::function<int()>;

/// Each adds its verb to the command line and sets `action` when that verb was chosen.
void add_render_command(CLI::App& app, Action& action);
void add_diff_command(CLI::App& app, Action& action);
/// `probe` is the command that stood after --probe, which may look like options of ours; empty if there was none.
void add_check_command(CLI::App& app, Action& action, std::vector<std::string> probe);
void add_corpus_command(CLI::App& app, Action& action);
void add_oracle_command(CLI::App& app, Action& action);
void add_grade_command(CLI::App& app, Action& action);
void add_growth_command(CLI::App& app, Action& action);
void add_suite_command(CLI::App& app, Action& action);
void add_mesh_command(CLI::App& app, Action& action);
void add_probe_command(CLI::App& app, Action& action);

}  // namespace plumb

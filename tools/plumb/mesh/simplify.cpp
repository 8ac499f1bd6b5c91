#include "tools/plumb/mesh/mesh_command.h"

namespace plumb {

void add_mesh_simplify(CLI::App&, Action&) {}

}  // namespace plumb

#include "tools/plumb/mesh/mesh_command.h"

namespace plumb {

void add_mesh_info(CLI::App&, Action&) {}

}  // namespace plumb

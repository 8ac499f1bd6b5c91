#pragma once

#include "scenes/dialect.h"
#include "scenes/kind.h"

namespace plumb {

/// All kinds that a scene of the dialect may use: what the reader, its messages and the manual know.
KindTable renderer_kinds(Dialect dialect);

}  // namespace plumb

#pragma once

#include <cstdint>
#include <span>
#include <utility>

#include "renderer/accel/binned_split.h"
#include "renderer/accel/triangle_group.h"
#include "renderer/accel/worker_pool.h"

namespace plumb {

/// The groups of `range`, a part of `groups`, in two: by the plane of the least cost by the surface area heuristic over
/// bins [Wald 2007], those below it moved to the front. Halves by number where no plane parts the centres, and where
/// `by_number` says so. Long ranges are binned and moved by all threads of the pool. The order that is left behind does
/// not depend on their number. Requires at least two groups.
std::pair<GroupRange, GroupRange> split_groups(std::span<TriangleGroup> groups, const GroupRange& range, bool by_number,
                                               WorkerPool& pool);

}  // namespace plumb

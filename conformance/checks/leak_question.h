#pragma once

#include <span>

#include "conformance/checks/check.h"
#include "conformance/families/closed_meshes.h"

namespace plumb {

/// Shoots about a million rays (times intensity and pace) from inside of closed surfaces, those of `surfaces` that the
/// subject can build, evenly. Any that hits nothing is an escape, and one is a failure; no rounding excuses it. A
/// subject that promises nothing of edges is UnsupportedBySubject.
CheckResult check_leaks(std::span<const ClosedSurface> surfaces, Subject& subject, const CheckOptions& options);

}  // namespace plumb

#pragma once

#include <string>

#include "conformance/subject/subject.h"
#include "reference/exact_hit.h"

namespace plumb {

/// A number as a hex float, which reads back to the same bits everywhere: `0x1.8p+1`.
std::string hex(double value);
/// `miss`, or `hit at t = 0x1.8p+1`.
std::string describe(const SubjectHit& answer);
/// The class, and t of its first crossing.
std::string describe(const ExactHit& truth);
/// The command that asks the oracle the same: `plumb oracle ray --triangle ... --origin ... --direction ...`. For a
/// mesh its size stands in place of it.
std::string oracle_command(const PlacedShape& shape, const Ray& ray);

}  // namespace plumb

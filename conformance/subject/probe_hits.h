#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "conformance/subject/probe_surfaces.h"
#include "conformance/subject/subject.h"

namespace plumb {

/// A hit, or `null`, of a program's answer, its surface taken from the program's list to the scene. Throws
/// SubjectFailure for what is none: `protocol`, or `not_finite`.
SubjectHit read_hit(const nlohmann::json& hit, std::span<const ProbePlace> places);

/// Object to world, its inverse and inverse transpose.
SubjectMatrices read_matrices(const nlohmann::json& matrices);

/// A world box as min x y z, max x y z.
Bounds3 read_bounds(const nlohmann::json& bounds);

}  // namespace plumb

#pragma once

#include <span>
#include <string_view>

#include "conformance/checks/check.h"
#include "conformance/families/family.h"

namespace plumb {

/// Asks the world boxes of the surfaces of these families (about `count` in all) and judges each exactly: every point
/// of the shape is inside, and how loose the faces are. `fail` with `not_contained` for a box that cuts its shape;
/// quality_warning with `loose` for one that is looser than 4 units in the last place of the larger of coordinate and
/// extent; gold (evidence) where no face is looser than one ulp. A float subject's units are those of float.
CheckResult check_bounds(std::span<const std::string_view> families, Subject& subject, const CheckOptions& options);

/// Asks the averagePosition of such surfaces: it lies in the box that was reported.
CheckResult check_average_positions(std::span<const std::string_view> families, Subject& subject,
                                    const CheckOptions& options);

/// Scenes of the families' surfaces, of those kinds that the subject builds, a few at a time.
std::vector<SubjectScene> bounds_scenes(std::span<const std::string_view> families, const Subject& subject,
                                        const CheckOptions& options);

/// The shapes of a loaded scene with the matrices that the subject holds them under: its own where it reports them.
std::vector<PlacedShape> placed_shapes(Subject& subject, const SubjectScene& scene);

}  // namespace plumb

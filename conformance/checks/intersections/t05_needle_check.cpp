#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind t05_needle_check_kind{
    .id = "T5",
    .title = "Triangles like needles",
    .asks = "Triangles very much longer than wide.",
    .matters =
        "Beams, blades of grass and badly tessellated models vanish where a fixed epsilon rejects their determinant.",
    .tolerance = kClassTolerance,
    .run = [](Subject& subject, const CheckOptions& options) { return check_family("T5", subject, options); },
};

}  // namespace plumb

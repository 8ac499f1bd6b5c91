#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind t10_on_surface_check_kind{
    .id = "T10",
    .title = "Rays that begin on the triangle",
    .asks = "Origins on a vertex, an edge or the face, at t = 0.",
    .matters = "Shadow and mirror rays begin on surfaces: acne, or light that leaks through corners.",
    .tolerance =
        "As for the other families of single surfaces. t is near zero, where its relative error has no bound, and is "
        "told only.",
    .run = [](Subject& subject,
              const CheckOptions& options) { return check_family("T10", subject, options, TimeRule::told); },
};

}  // namespace plumb

#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind t10_on_surface_check_kind{
    .id = "T10",
    .title = "Rays that begin on the triangle",
    .asks = "Origins on a vertex, an edge or the face, at t = 0.",
    .matters = "Shadow and mirror rays begin on surfaces: acne, or light that leaks through corners.",
    .tolerance =
        "As for the other families of single surfaces, but t is near zero, where its relative error has no bound: only "
        "one that is off by 2^20 u of the triangle's distance counts. As rounding moves the origin in front of the "
        "triangle as often as behind it, of the hits that it may lose (64 or more) at most three quarters may be "
        "missed.",
    .run =
        [](Subject& subject, const CheckOptions& options) {
          return check_family("T10", subject, options, TimeRule::told, NormalRule::told, BoundaryRule::judged);
        },
};

}  // namespace plumb

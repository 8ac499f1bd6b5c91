#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind s04_on_sphere_check_kind{
    .id = "S4",
    .title = "Rays that begin on a sphere",
    .asks = "The origin on the sphere, inwards and outwards.",
    .matters = "Refracted and shadow rays take the wrong root: glass is black, shadows have acne.",
    .tolerance =
        "As for the other families of single surfaces, but t is near zero, where its relative error has no bound: only "
        "one that is off by 2^20 u of the sphere's distance counts.",
    .run = [](Subject& subject,
              const CheckOptions& options) { return check_family("S4", subject, options, TimeRule::told); },
};

}  // namespace plumb

#include "conformance/checks/class_question.h"
#include "conformance/checks/leak_question.h"

namespace plumb {

extern const CheckKind leak_solid_check_kind{
    .id = "leak-solid",
    .title = "Rays out of capped solids",
    .asks =
        "Rays from inside of spheres, boxes, cylinders and cones, aimed at rims, edges, corners and faces: does any "
        "escape?",
    .matters = "Light leaks at the rim of cylinders, and refracted rays are lost in glass.",
    .tolerance = "None: a ray that begins strictly inside of a closed surface meets it, however it is rounded.",
    .run =
        [](Subject& subject, const CheckOptions& options) {
          return check_leaks(closed_solids(subject.contract().precision), subject, options);
        },
};

}  // namespace plumb

#include "conformance/checks/class_question.h"
#include "conformance/checks/leak_question.h"

namespace plumb {

extern const CheckKind leak_solid_placed_check_kind{
    .id = "leak-solid-placed",
    .title = "Rays out of capped solids in groups",
    .asks = "The same solids under nested, sheared, mirrored and far transforms: does any ray escape?",
    .matters = "Light leaks out of squashed and turned solids.",
    .tolerance = "None: a ray that begins strictly inside of a closed surface meets it, however it is rounded.",
    .run =
        [](Subject& subject, const CheckOptions& options) {
          return check_leaks(under_matrices(closed_solids(subject.contract().precision), subject.contract().precision),
                             subject, options);
        },
};

}  // namespace plumb

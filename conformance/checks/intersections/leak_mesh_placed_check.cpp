#include "conformance/checks/class_question.h"
#include "conformance/checks/leak_question.h"

namespace plumb {

extern const CheckKind leak_mesh_placed_check_kind{
    .id = "leak-mesh-placed",
    .title = "Rays out of closed meshes in groups",
    .asks = "The same meshes under nested, sheared, mirrored and far transforms: does any ray escape?",
    .matters =
        "A model that is tight by itself leaks in a scene: its neighbours see the ray rounded differently, or its box "
        "is too tight.",
    .tolerance = "None: a ray that begins strictly inside of a closed surface meets it, however it is rounded.",
    .run =
        [](Subject& subject, const CheckOptions& options) {
          return check_leaks(under_matrices(closed_meshes(family_precision(subject.contract(), ShapeKind::mesh)),
                                            subject.contract().precision),
                             subject, options);
        },
};

}  // namespace plumb

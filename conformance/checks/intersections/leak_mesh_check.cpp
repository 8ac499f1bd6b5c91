#include "conformance/checks/class_question.h"
#include "conformance/checks/leak_question.h"

namespace plumb {

extern const CheckKind leak_mesh_check_kind{
    .id = "leak-mesh",
    .title = "Rays out of closed meshes",
    .asks = "Rays from inside of closed meshes, aimed at vertices, edges and faces: does any escape?",
    .matters = "Background shines through single pixels of closed models, and light through walls.",
    .tolerance = "None: a ray that begins strictly inside of a closed surface meets it, however it is rounded.",
    .run =
        [](Subject& subject, const CheckOptions& options) {
          return check_leaks(closed_meshes(family_precision(subject.contract(), ShapeKind::mesh)), subject, options);
        },
};

}  // namespace plumb

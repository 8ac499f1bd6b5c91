#include "scenes/scene_kind.h"

#include <array>

namespace plumb {
namespace {

constexpr std::array kSceneParameters{
    Parameter{.name = "camera",
              .type = ValueType::object,
              .meaning = "where the picture is taken from; without one, the camera's defaults",
              .presence = Presence::optional,
              .role = Role::camera},
    Parameter{.name = "image",
              .type = ValueType::size,
              .meaning = "width and height of the picture",
              .unit = "pixels",
              .range = Range::positive},
    Parameter{.name = "samples",
              .type = ValueType::integer,
              .meaning = "samples a pixel, rounded to the nearest square N x N, at least 1",
              .presence = Presence::defaulted,
              .default_text = "1",
              .range = Range::not_negative,
              .largest = 1 << 20},
    Parameter{.name = "light",
              .type = ValueType::object,
              .meaning = "a light",
              .presence = Presence::optional,
              .role = Role::light,
              .repeatable = true},
    Parameter{.name = "shader",
              .type = ValueType::object,
              .meaning = "a shader to be referred to by its name",
              .presence = Presence::optional,
              .role = Role::shader,
              .repeatable = true},
    Parameter{.name = "surface",
              .type = ValueType::object,
              .meaning = "a surface or a group of them",
              .presence = Presence::optional,
              .role = Role::surface,
              .repeatable = true},
    Parameter{.name = "maxDepth",
              .type = ValueType::integer,
              .meaning = "the longest chain of rays: a camera ray has depth 1, a deeper ray than this is black",
              .presence = Presence::defaulted,
              .default_text = "12",
              .range = Range::positive,
              .largest = kDeepestPath,
              .since = "plumbline"},
    Parameter{
        .name = "minContribution",
        .type = ValueType::number,
        .meaning = "a reflected or refracted ray that would count for less than this share of its pixel is dropped",
        .presence = Presence::defaulted,
        .default_text = "0.01",
        .range = Range::not_negative,
        .since = "plumbline"},
};

constexpr std::array kGroupParameters{
    Parameter{.name = "translate",
              .type = ValueType::vector,
              .meaning = "moves the members; transforms multiply in file order, the first outermost",
              .presence = Presence::optional,
              .repeatable = true},
    Parameter{.name = "rotate",
              .type = ValueType::vector,
              .meaning = "turns the members about x, then y, then z",
              .presence = Presence::optional,
              .unit = "degrees",
              .repeatable = true},
    Parameter{.name = "scale",
              .type = ValueType::vector,
              .meaning = "scales the members along x, y, z",
              .presence = Presence::optional,
              .repeatable = true},
    Parameter{.name = "shader",
              .type = ValueType::object,
              .meaning = "applies to the members that have none",
              .presence = Presence::optional,
              .role = Role::shader},
    Parameter{.name = "surface",
              .type = ValueType::object,
              .meaning = "a member: a surface, or a group again",
              .presence = Presence::optional,
              .role = Role::surface,
              .repeatable = true},
};

}  // namespace

const Kind scene_kind{Role::scene, "Scene", "The root element, <scene>.", kSceneParameters};
const Kind group_kind{
    Role::surface, "Group",
    "Members under a common transform. All transforms of a group apply to all of its members, wherever they stand.",
    kGroupParameters};

}  // namespace plumb

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/cameras/camera.h"

namespace plumb {
namespace {

class PerspectiveCamera : public Camera {
 public:
  PerspectiveCamera(const Point3& eye, const Vec3& to_center, const Vec3& right, const Vec3& up)
      : eye_(eye), to_center_(to_center), right_(right), up_(up) {}

  Ray ray(double u, double v) const override {
    return {eye_, normalized(to_center_ + (u - 0.5) * right_ + (v - 0.5) * up_)};
  }

 private:
  Point3 eye_;
  Vec3 to_center_;
  Vec3 right_;
  Vec3 up_;
};

constexpr std::array kParameters{
    Parameter{.name = "viewPoint",
              .type = ValueType::point,
              .meaning = "the eye, the centre of projection",
              .presence = Presence::defaulted,
              .default_text = "0 0 0"},
    Parameter{.name = "viewDir",
              .type = ValueType::vector,
              .meaning = "towards the centre of the view window; of any length",
              .presence = Presence::defaulted,
              .default_text = "0 0 -1"},
    Parameter{.name = "viewUp",
              .type = ValueType::vector,
              .meaning = "what is up in the picture",
              .presence = Presence::defaulted,
              .default_text = "0 1 0"},
    Parameter{.name = "projNormal",
              .type = ValueType::vector,
              .meaning = "normal of the projection plane, of any length and either sign; without one the plane is "
                         "perpendicular to viewDir",
              .presence = Presence::optional},
    Parameter{.name = "projDistance",
              .type = ValueType::number,
              .meaning = "from the eye to the centre of the view window",
              .presence = Presence::defaulted,
              .default_text = "1",
              .range = Range::positive},
    Parameter{.name = "viewWidth",
              .type = ValueType::number,
              .meaning = "width of the view window",
              .presence = Presence::defaulted,
              .default_text = "1",
              .range = Range::positive},
    Parameter{.name = "viewHeight",
              .type = ValueType::number,
              .meaning = "height of the view window",
              .presence = Presence::defaulted,
              .default_text = "1",
              .range = Range::positive},
};

/// What rounding may leave of a product of unit vectors that is zero: three products and two sums, each within u, and
/// the vectors' own.
constexpr double kRounding = 8 * 0x1p-53;

/// The unit vector along a parameter. One whose square would leave the range of doubles is scaled first; others are
/// not, as that would round.
Vec3 direction(const ObjectDescription& object, std::string_view parameter) {
  Vec3 v = object.vector(parameter);
  if (v == Vec3{})
    throw InputError(object.where(parameter), "<" + std::string(parameter) + "> is zero, expected a direction");
  const double largest = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  if (largest > 0x1p500 || largest < 0x1p-500) v = v / largest;
  return normalized(v);
}

std::unique_ptr<Camera> make(const ObjectDescription& object) {
  const Vec3 view = direction(object, "viewDir");
  const Vec3 up = direction(object, "viewUp");
  const std::string_view plane_given_by = object.has("projNormal") ? "projNormal" : "viewDir";
  const Vec3 normal = direction(object, plane_given_by);
  const double facing = dot(normal, view);
  if (std::fabs(facing) <= kRounding) {
    throw InputError(
        object.where("projNormal"),
        "<projNormal> is perpendicular to viewDir, so the view window is seen edge-on; expected another direction");
  }
  // The plane's normal is turned to point against the view.
  const Vec3 w = facing > 0 ? -normal : normal;
  const Vec3 across = cross(up, w);
  if (length(across) <= kRounding) {
    throw InputError(object.where("viewUp"), "<viewUp> is parallel to " + std::string(plane_given_by) +
                                                 ", so nothing is up in the picture; expected another direction");
  }
  const Vec3 u = normalized(across);
  const Vec3 v = cross(w, u);
  return std::make_unique<PerspectiveCamera>(object.point("viewPoint"), object.number("projDistance") * view,
                                             object.number("viewWidth") * u, object.number("viewHeight") * v);
}

}  // namespace

extern const CameraKind perspective_camera_kind{
    {Role::camera, "Camera",
     "A pinhole camera, oblique where projNormal differs from viewDir. Its type need not be written.", kParameters},
    make};

}  // namespace plumb

#include <array>

#include "renderer/lights/light.h"

namespace plumb {
namespace {

class PointLight : public Light {
 public:
  PointLight(const Point3& position, const Color& intensity) : position_(position), intensity_(intensity) {}

  LightSample sample(const Point3& point) const override { return {position_ - point, intensity_}; }

 private:
  Point3 position_;
  Color intensity_;
};

constexpr std::array kParameters{
    Parameter{.name = "position",
              .type = ValueType::point,
              .meaning = "where it is",
              .presence = Presence::defaulted,
              .default_text = "0 0 0"},
    Parameter{.name = "intensity",
              .type = ValueType::color,
              .meaning = "its strength, the same at any distance",
              .presence = Presence::defaulted,
              .default_text = "1 1 1"},
    Parameter{.name = "color",
              .type = ValueType::color,
              .meaning = "another name of intensity",
              .presence = Presence::optional,
              .alias_of = "intensity"},
};

std::unique_ptr<Light> make(const ObjectDescription& object) {
  return std::make_unique<PointLight>(object.point("position"), object.color("intensity"));
}

}  // namespace

extern const LightKind point_light_kind{
    {Role::light, "Light", "A light at a point, without falloff. Its type need not be written.", kParameters}, make};

}  // namespace plumb

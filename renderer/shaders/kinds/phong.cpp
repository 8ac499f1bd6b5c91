#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/integrator/tracer.h"
#include "renderer/shaders/shader.h"

namespace plumb {
namespace {

class Phong : public Shader {
 public:
  Phong(const Color& diffuse, const Color& specular, double exponent)
      : diffuse_(diffuse), specular_(specular), exponent_(exponent) {}

  Color shade(const ShadingPoint& point, const Path&, Tracer& tracer) const override {
    Color sum;
    for (const auto& light : tracer.scene().lights()) {
      const LightSample sample = light->sample(point.position);
      if (!tracer.sees(point.position, sample)) continue;
      const Vec3 to_light = normalized(sample.to_light);
      const Vec3 half = normalized(to_light + point.to_viewer);
      const double diffuse = std::max(0.0, dot(point.normal, to_light));
      const double highlight = std::pow(std::max(0.0, dot(point.normal, half)), exponent_);
      sum += sample.intensity * (diffuse * diffuse_ + highlight * specular_);
    }
    return sum;
  }

 private:
  Color diffuse_;
  Color specular_;
  double exponent_;
};

constexpr std::array kParameters{
    Parameter{.name = "diffuseColor",
              .type = ValueType::color,
              .meaning = "kd: the share of light it scatters evenly",
              .presence = Presence::defaulted,
              .default_text = "1 1 1"},
    Parameter{.name = "specularColor",
              .type = ValueType::color,
              .meaning = "ks: the strength of the highlight",
              .presence = Presence::defaulted,
              .default_text = "1 1 1"},
    Parameter{.name = "exponent",
              .type = ValueType::number,
              .meaning = "how sharp the highlight is",
              .presence = Presence::defaulted,
              .default_text = "1",
              .range = Range::not_negative},
};

std::unique_ptr<Shader> make(const ObjectDescription& object, const ShaderOf&) {
  return std::make_unique<Phong>(object.color("diffuseColor"), object.color("specularColor"),
                                 object.number("exponent"));
}

}  // namespace

extern const ShaderKind phong_kind{
    {Role::shader, "Phong",
     "Lambertian plus a highlight ks I max(0, n.h)^exponent, h the unit half vector of light and viewer.", kParameters},
    make};

}  // namespace plumb

#include <array>

#include "renderer/integrator/tracer.h"
#include "renderer/shaders/shader.h"

namespace plumb {
namespace {

class Lambertian : public Shader {
 public:
  explicit Lambertian(const Color& diffuse) : diffuse_(diffuse) {}

  Color shade(const ShadingPoint& point, const Path&, Tracer& tracer) const override {
    Color sum;
    for (const auto& light : tracer.scene().lights()) {
      const LightSample sample = light->sample(point.position);
      const double cosine = dot(point.normal, normalized(sample.to_light));
      if (cosine > 0 && tracer.sees(point.position, sample)) sum += cosine * (diffuse_ * sample.intensity);
    }
    return sum;
  }

 private:
  Color diffuse_;
};

constexpr std::array kParameters{
    Parameter{.name = "diffuseColor",
              .type = ValueType::color,
              .meaning = "kd: the share of light it scatters evenly",
              .presence = Presence::defaulted,
              .default_text = "1 1 1"},
};

std::unique_ptr<Shader> make(const ObjectDescription& object, const ShaderOf&) {
  return std::make_unique<Lambertian>(object.color("diffuseColor"));
}

}  // namespace

extern const ShaderKind lambertian_kind{
    {Role::shader, "Lambertian", "A matt surface: the sum over the visible lights of kd I max(0, n.l).", kParameters},
    make};

}  // namespace plumb

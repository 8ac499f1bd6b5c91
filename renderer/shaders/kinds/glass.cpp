#include <array>

#include "renderer/integrator/tracer.h"
#include "renderer/shaders/shader.h"

namespace plumb {
namespace {

class Glass : public Shader {
 public:
  explicit Glass(double index) : index_(index) {}

  Color shade(const ShadingPoint& point, const Path& path, Tracer& tracer) const override {
    const double facing = dot(point.normal, point.to_viewer);
    const bool inside = facing < 0;
    const Normal3 normal = inside ? -point.normal : point.normal;
    const Interface interface = inside ? Interface{-facing, index_, 1} : Interface{facing, 1, index_};
    const Ray mirror{point.position, reflected(point.to_viewer, normal)};
    const std::optional<double> beyond = refracted_cosine(interface);
    if (!beyond) return tracer.follow(mirror, RayKind::reflection, path, 1);
    const double r = reflectance(interface, tracer.scene().fresnel());
    const Ray through{point.position, refracted(point.to_viewer, normal, interface, *beyond)};
    return r * tracer.follow(mirror, RayKind::reflection, path, r) +
           (1 - r) * tracer.follow(through, RayKind::refraction, path, 1 - r);
  }

 private:
  double index_;
};

constexpr std::array kParameters{
    Parameter{.name = "refractiveIndex",
              .type = ValueType::number,
              .meaning = "of the inside, the side away from the normal; outside it is 1",
              .range = Range::positive},
};

std::unique_ptr<Shader> make(const ObjectDescription& object, const ShaderOf&) {
  return std::make_unique<Glass>(object.number("refractiveIndex"));
}

}  // namespace

extern const ShaderKind glass_kind{
    {Role::shader, "Glass",
     "The surface of a clear dielectric: R mirror image + (1 - R) refracted image, from both sides.", kParameters},
    make};

}  // namespace plumb

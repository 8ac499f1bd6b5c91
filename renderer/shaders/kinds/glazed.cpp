#include <array>

#include "renderer/integrator/tracer.h"
#include "renderer/shaders/shader.h"

namespace plumb {
namespace {

class Glazed : public Shader {
 public:
  Glazed(double index, const Shader& substrate) : index_(index), substrate_(substrate) {}

  Color shade(const ShadingPoint& point, const Path& path, Tracer& tracer) const override {
    const double cosine = dot(point.normal, point.to_viewer);
    if (!(cosine > 0)) return substrate_.shade(point, path, tracer);
    const double r = reflectance({cosine, 1, index_}, tracer.scene().fresnel());
    const Path below{path.depth, path.contribution * (1 - r)};
    const Color substrate = substrate_.shade(point, below, tracer);
    const Color mirrored =
        tracer.follow({point.position, reflected(point.to_viewer, point.normal)}, RayKind::reflection, path, r);
    return (1 - r) * substrate + r * mirrored;
  }

 private:
  double index_;
  const Shader& substrate_;
};

constexpr std::array kParameters{
    Parameter{.name = "refractiveIndex",
              .type = ValueType::number,
              .meaning = "of the glaze; outside of it the index is 1",
              .range = Range::positive},
    Parameter{
        .name = "substrate", .type = ValueType::object, .meaning = "the shader below the glaze", .role = Role::shader},
};

std::unique_ptr<Shader> make(const ObjectDescription& object, const ShaderOf& shader_of) {
  return std::make_unique<Glazed>(object.number("refractiveIndex"), shader_of(*object.object("substrate")));
}

}  // namespace

extern const ShaderKind glazed_kind{
    {Role::shader, "Glazed",
     "A thin dielectric layer over another shader: (1 - R) substrate + R mirror image, R by Fresnel.", kParameters},
    make};

}  // namespace plumb

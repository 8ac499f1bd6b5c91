#include "renderer/kinds.h"

#include "renderer/cameras/camera.h"
#include "renderer/lights/light.h"
#include "renderer/shaders/shader.h"
#include "renderer/surfaces/surface.h"

namespace plumb {

KindTable renderer_kinds(Dialect dialect) {
  KindTable table;
  for (const SurfaceKind* kind : surface_kinds()) table.kinds.push_back(&kind->kind);
  for (const ShaderKind* kind : shader_kinds()) table.kinds.push_back(&kind->kind);
  for (const LightKind* kind : light_kinds()) table.kinds.push_back(&kind->kind);
  for (const CameraKind* kind : camera_kinds()) table.kinds.push_back(&kind->kind);
  switch (dialect) {
    case Dialect::pa3_2011:
      table.untyped = {table.find(Role::light, "Light"), table.find(Role::camera, "Camera")};
  }
  return table;
}

}  // namespace plumb

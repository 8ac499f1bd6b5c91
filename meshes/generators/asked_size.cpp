#include "meshes/generators/asked_size.h"

#include <string>

#include "renderer/math/input_error.h"

namespace plumb {

std::uint64_t asked_triangles(const MeshRequest& request) {
  if (request.triangles < 1 || request.triangles > 100'000'000)
    throw InputError({}, std::to_string(request.triangles) + " triangles are asked for, expected 1 to 100000000");
  return request.triangles;
}

}  // namespace plumb

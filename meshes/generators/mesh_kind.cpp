#include "meshes/generators/mesh_kind.h"

#include <string>
#include <vector>

#include "renderer/math/input_error.h"
#include "renderer/math/nearest_name.h"

namespace plumb {

const MeshKind& mesh_kind(std::string_view id) {
  std::vector<std::string_view> names;
  for (const MeshKind* kind : mesh_kinds()) {
    if (kind->id == id) return *kind;
    names.push_back(kind->id);
  }
  throw InputError({}, "no mesh family is called '" + std::string(id) + "'" + did_you_mean(id, names));
}

}  // namespace plumb

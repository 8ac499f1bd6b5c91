#include "bench/race/race_meshes.h"

#include <filesystem>

#include "bench/race/float_numbers.h"
#include "meshes/generators/mesh_kind.h"
#include "meshes/read_mesh.h"

namespace plumb::bench {
namespace {

std::filesystem::path file_of(std::string_view name) {
  return std::filesystem::path(PLUMB_SHARED_DIR) / "meshes" / (std::string(name) + ".ply");
}

std::shared_ptr<const TriangleMesh> in_floats(TriangleMesh mesh) {
  for (Point3& p : mesh.positions) p = as_floats(p);
  mesh.normals.clear();
  mesh.texcoords.clear();
  return std::make_shared<const TriangleMesh>(std::move(mesh));
}

}  // namespace

std::vector<std::string> race_mesh_names() {
  std::vector<std::string> names;
  for (const char* file : {"bunny69k", "igea268k"})
    if (std::filesystem::exists(file_of(file))) names.push_back(file);
  names.insert(names.end(), {"city380k", "knot1500k"});
  return names;
}

std::shared_ptr<const TriangleMesh> race_mesh(std::string_view name) {
  if (name == "city380k") return in_floats(mesh_kind("city").make({.triangles = 380'000, .progress = {}}));
  if (name == "knot1500k") return knot_mesh(1'500'000);
  return in_floats(read_mesh(file_of(name)));
}

std::shared_ptr<const TriangleMesh> knot_mesh(std::size_t triangles) {
  return in_floats(mesh_kind("torus_knot").make({.triangles = triangles, .progress = {}}));
}

}  // namespace plumb::bench

#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "renderer/build_scene.h"
#include "renderer/film/render.h"
#include "renderer/integrator/tracer.h"
#include "renderer/kinds.h"
#include "scenes/read_scene.h"

namespace plumb {

/// The path of a file in a folder that no other process uses. The folder exists.
inline std::filesystem::path scene_test_file(const std::string& name) {
  struct Folder {
    ~Folder() { std::filesystem::remove_all(path); }
    std::filesystem::path path =
        std::filesystem::path(::testing::TempDir()) / ("plumb-renderer-" + std::to_string(getpid()));
  };
  static const Folder of_this_process;
  const std::filesystem::path& folder = of_this_process.path;
  std::filesystem::create_directories(folder);
  return folder / name;
}

inline std::filesystem::path write_scene_test_file(const std::string& name, const std::string& content) {
  const auto file = scene_test_file(name);
  std::ofstream(file, std::ios::binary).write(content.data(), static_cast<std::streamsize>(content.size()));
  return file;
}

/// The mesh with its positions as a scene keeps them: in single precision. Without the volatile, GCC 12 drops the
/// rounding when it vectorises.
inline TriangleMesh in_single_precision(TriangleMesh mesh) {
  for (Point3& position : mesh.positions) {
    for (int axis = 0; axis < 3; ++axis) {
      volatile float rounded = static_cast<float>(position[axis]);
      position[axis] = static_cast<double>(rounded);
    }
  }
  return mesh;
}

/// A file on its way through reader, meshes and builder.
struct ReadScene {
  SceneDescription description;
  std::vector<std::string> warnings;
  Scene scene;
};

inline ReadScene read_and_build(const std::filesystem::path& file, const BuildOptions& options = {}) {
  SceneDescription description = read_scene(file, renderer_kinds(Dialect::pa3_2011));
  std::vector<std::string> warnings = description.warnings;
  const MeshTable meshes = load_meshes(description);
  Scene scene = build_scene(description, meshes, options, warnings);
  return {std::move(description), std::move(warnings), std::move(scene)};
}

/// The scene with these elements and an image of 8x8, if they give none.
inline ReadScene scene_of(const std::string& elements, const BuildOptions& options = {}) {
  const std::string image = elements.find("<image>") == std::string::npos ? "<image>8 8</image>" : "";
  return read_and_build(write_scene_test_file("scene.xml", "<scene>" + image + elements + "</scene>"), options);
}

/// A scene of one surface outside of any group, and that surface in its own frame.
class OneSurface {
 public:
  explicit OneSurface(const std::string& element, const BuildOptions& options = {})
      : read_(scene_of(element, options)) {}
  const Surface& operator*() const { return *read_.scene.placed().at(0).surface; }
  const Surface* operator->() const { return &**this; }
  std::optional<SurfaceHit> hit(const Ray& ray) const {
    TraceCounters counters;
    return (*this)->intersect(ray, counters);
  }
  bool blocks(const Ray& ray) const {
    TraceCounters counters;
    return (*this)->blocks(ray, counters);
  }
  /// Of unit length.
  Normal3 normal(const Ray& ray) const { return normalized((*this)->normal(ray, hit(ray).value())); }
  const std::vector<std::string>& warnings() const { return read_.warnings; }

 private:
  ReadScene read_;
};

/// What a ray brings back through this scene, as a camera ray.
inline Color traced(const Scene& scene, const Ray& ray, TraceCounters* counters = nullptr) {
  Tracer tracer(scene);
  const Color color = tracer.trace(ray, RayKind::primary, Path{});
  if (counters) *counters = tracer.counters();
  return color;
}

/// Whether two doubles have the same bits, NaN and the sign of zero included.
inline bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

inline bool same_bits(const Image& a, const Image& b) {
  return a.width() == b.width() && a.height() == b.height() &&
         std::memcmp(a.pixels().data(), b.pixels().data(), a.pixels().size() * sizeof(Color)) == 0;
}

/// Rays that have a NaN in one place each, otherwise aimed at the origin from (0.1, 0.2, 5).
inline std::vector<Ray> rays_with_nan() {
  const Ray sound{{0.1, 0.2, 5}, {0, 0, -1}};
  std::vector<Ray> rays;
  for (int i = 0; i < 8; ++i) {
    Ray ray = sound;
    (i < 3 ? ray.origin[i] : i < 6 ? ray.direction[i - 3] : i == 6 ? ray.t_min : ray.t_max) = std::nan("");
    rays.push_back(ray);
  }
  return rays;
}

}  // namespace plumb

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "conformance/kernel/plumb_kernel.h"
#include "conformance/subject/kernel_message.h"
#include "conformance/subject/subject.h"

namespace plumb {

/// A scene in the form of plumb_kernel.h, with all that it points to. A mesh that several surfaces share is there once,
/// so a kernel can tell instances by its pointers. A single triangle is a mesh of one.
class KernelScene {
 public:
  KernelScene() = default;
  explicit KernelScene(const SubjectScene& scene);
  KernelScene(KernelScene&&) = default;
  KernelScene& operator=(KernelScene&&) = default;

  std::span<const plumb_surface> surfaces() const { return surfaces_; }

  void write(KernelMessageWriter& message) const;
  /// Throws KernelMessageFault.
  static KernelScene read(KernelMessageReader& message);

 private:
  struct Mesh {
    std::vector<double> positions;
    std::vector<std::uint32_t> triangles;
    plumb_mesh view() const;
  };
  static Mesh flat(const TriangleMesh& mesh);
  /// Points the surfaces at their meshes; only then does the list of meshes no longer grow.
  void link();

  std::vector<Mesh> meshes_;
  std::vector<plumb_surface> surfaces_;
  /// The mesh of each surface; kNoMesh for the others.
  std::vector<std::uint32_t> mesh_of_;
};

/// Rays, each number in an array of its own.
class KernelRays {
 public:
  explicit KernelRays(std::span<const Ray> rays);

  std::size_t count() const { return numbers_.size() / kArrays; }
  /// Of rays [begin, end).
  plumb_rays view(std::size_t begin, std::size_t end) const;
  plumb_rays view() const { return view(0, count()); }

  void write(KernelMessageWriter& message) const;
  /// Throws KernelMessageFault.
  static KernelRays read(KernelMessageReader& message);

 private:
  KernelRays() = default;
  static constexpr std::size_t kArrays = 8;
  std::vector<double> numbers_;  // array by array
};

/// Calls `visit` with each number of a surface that its kind uses: coordinates and lengths, without its matrix.
template <class Visit>
void for_each_length(const plumb_surface& surface, Visit visit) {
  const auto each = [&](const double* numbers, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) visit(numbers[i]);
  };
  switch (surface.kind) {
    case PLUMB_MESH:
      return each(surface.mesh.positions, 3 * surface.mesh.vertex_count);
    case PLUMB_BOX:
      each(surface.box_min, 3);
      return each(surface.box_max, 3);
    case PLUMB_CONE:
      visit(surface.tip_z);
      [[fallthrough]];
    case PLUMB_CYLINDER:
      visit(surface.height);
      [[fallthrough]];
    default:
      each(surface.center, 3);
      visit(surface.radius);
  }
}

}  // namespace plumb

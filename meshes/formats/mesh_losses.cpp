#include "meshes/formats/mesh_losses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <vector>

#include "meshes/mesh_notes.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

/// The nearest float. Not inlined on purpose: GCC 12 drops the rounding of double(float(x)) where it vectorises.
[[gnu::noinline]] float nearest_float(double x) { return static_cast<float>(x); }

/// Counts the numbers of one kind that single precision changes.
class Rounded {
 public:
  Rounded(std::string kind, const std::filesystem::path& file) : kind_(std::move(kind)), file_(file) {}

  void add(double x) {
    ++numbers_;
    const double kept = double{nearest_float(x)};
    if (!std::isfinite(kept)) refuse(x);
    if (kept == x) return;
    ++changed_;
    largest_ = std::max(largest_, std::fabs(kept - x));
  }

  void say(MeshLosses& losses) const {
    if (changed_ == 0) return;
    losses.sentences.push_back(std::to_string(changed_) + " of " + std::to_string(numbers_) + " " + kind_ +
                               " rounded to single precision, by at most " + rounded_up(largest_));
  }

 private:
  static std::string number(double x, const char* format) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), format, x);
    return text.data();
  }
  /// With two digits.
  static std::string rounded_up(double x) {
    std::string text = number(x, "%.2g");
    for (double larger = x; std::strtod(text.c_str(), nullptr) < x; text = number(larger, "%.2g")) larger *= 1.01;
    return text;
  }
  [[noreturn]] void refuse(double x) const {
    throw InputError({file_.string()}, "of the " + kind_ + ", " + number(x, "%.9g") +
                                           " does not fit the single precision of this format; expected numbers up "
                                           "to 3.4e38, or a file in .msh");
  }

  std::string kind_;
  const std::filesystem::path& file_;
  std::size_t numbers_ = 0, changed_ = 0;
  double largest_ = 0;
};

std::size_t unused_vertices(const TriangleMesh& mesh) {
  std::vector<bool> used(mesh.positions.size());
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) used[vertex] = true;
  }
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
}

void say_what_stl_lacks(const TriangleMesh& mesh, MeshLosses& losses) {
  const std::string vertices = counted(mesh.positions.size(), "vertex", "vertices");
  if (!mesh.normals.empty()) losses.sentences.push_back("normals of " + vertices + ": STL has none of vertices");
  if (!mesh.texcoords.empty()) losses.sentences.push_back("texture coordinates of " + vertices + ": STL has none");
  if (const std::size_t unused = unused_vertices(mesh); unused > 0)
    losses.sentences.push_back(counted(unused, "vertex", "vertices") + " of no triangle: STL holds triangles alone");
  if (!mesh.triangles.empty()) {
    losses.sentences.push_back("which triangles share the " + vertices + ", and their order: STL repeats them at " +
                               std::to_string(3 * mesh.triangles.size()) +
                               " corners, and readers join what lies at one point");
  }
}

}  // namespace

MeshLosses losses_of(const TriangleMesh& mesh, const std::string& ending, const std::filesystem::path& file) {
  constexpr std::size_t kMost = std::numeric_limits<std::int32_t>::max();
  if (mesh.positions.size() > kMost || mesh.triangles.size() > kMost)
    throw InputError({file.string()}, "more than 2147483647 vertices or triangles; expected fewer in this format");
  Rounded coordinates("coordinates", file), normals("numbers of normals", file),
      texcoords("numbers of texture coordinates", file);
  for (const Point3& p : mesh.positions) {
    for (int axis = 0; axis < 3; ++axis) coordinates.add(p[axis]);
  }
  MeshLosses losses;
  coordinates.say(losses);
  if (ending == ".stl") {
    say_what_stl_lacks(mesh, losses);
    return losses;
  }
  for (const Normal3& n : mesh.normals) {
    for (int axis = 0; axis < 3; ++axis) normals.add(n[axis]);
  }
  for (const TexCoord& t : mesh.texcoords) {
    texcoords.add(t.u);
    texcoords.add(t.v);
  }
  normals.say(losses);
  texcoords.say(losses);
  if (ending == ".obj" && !(mesh.normals.empty() && mesh.texcoords.empty())) {
    if (const std::size_t unused = unused_vertices(mesh); unused > 0) {
      losses.sentences.push_back("normals and texture coordinates of " + counted(unused, "vertex", "vertices") +
                                 " of no triangle: OBJ gives them to the corners of faces");
    }
  }
  return losses;
}

}  // namespace plumb

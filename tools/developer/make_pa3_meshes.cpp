// make_pa3_meshes DIR: writes the generated meshes of the grading scenes (scenes/pa3) into a folder that exists.
//
// Numbers are rounded to a few decimals, so that the files stay small and their text is exact to the reader.

#include <array>
#include <cmath>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <initializer_list>
#include <iostream>

#include "meshes/formats/write_msh.h"
#include "meshes/generators/averaged_normals.h"
#include "meshes/generators/mesh_kind.h"

namespace {

using plumb::Normal3;
using plumb::Point3;
using plumb::TriangleMesh;

constexpr double kDigits = 1e4;
constexpr double kNormalDigits = 1e7;  // normals stay unit to 1e-6, as `plumb mesh check` wants them

/// The multiple of 1/digits nearest to the value; as a quotient of whole numbers it is the double nearest to the
/// decimal.
double rounded(double value, double digits) {
  const double whole = std::round(value * digits);
  return whole == 0 ? 0 : whole / digits;
}

void round_numbers(TriangleMesh& mesh) {
  for (Point3& p : mesh.positions) p = {rounded(p.x, kDigits), rounded(p.y, kDigits), rounded(p.z, kDigits)};
  for (Normal3& n : mesh.normals)
    n = {rounded(n.x, kNormalDigits), rounded(n.y, kNormalDigits), rounded(n.z, kNormalDigits)};
  for (plumb::TexCoord& t : mesh.texcoords) t = {rounded(t.u, kDigits), rounded(t.v, kDigits)};
}

TriangleMesh generated(const char* family, std::uint64_t triangles, std::uint64_t seed = 1) {
  return plumb::mesh_kind(family).make({.triangles = triangles, .seed = seed, .progress = {}});
}

/// A boulder with flat facets.
TriangleMesh boulder() {
  TriangleMesh mesh = generated("displaced_sphere", 320, 3);
  mesh.normals.clear();
  round_numbers(mesh);
  return mesh;
}

/// A knotted tube with a normal at each vertex.
TriangleMesh knot() {
  TriangleMesh mesh = generated("torus_knot", 800);
  round_numbers(mesh);
  return mesh;
}

/// An open cloth with texture coordinates before its normals, large enough to reach behind the camera.
TriangleMesh cloth() {
  TriangleMesh mesh = generated("terrain", 128, 5);
  for (Point3& p : mesh.positions) p = {6 * p.x, 5 * p.y - 2, 6 * p.z};
  mesh.normals = plumb::averaged_normals(mesh, [](const Point3&) { return Normal3{0, 1, 0}; });
  round_numbers(mesh);
  return mesh;
}

/// An open folding screen without normals: four leaves in a zigzag along x, each of two triangles. Its fronts look
/// towards +z, or towards -z if it is `turned`.
TriangleMesh screen(Point3 middle, bool turned) {
  TriangleMesh mesh;
  constexpr std::uint32_t kLeaves = 4;
  for (std::uint32_t i = 0; i <= kLeaves; ++i) {
    const double x = middle.x + 0.375 * i - 0.75, z = middle.z + (i % 2 == 0 ? -0.25 : 0.25);
    mesh.positions.insert(mesh.positions.end(), {{x, middle.y - 0.875, z}, {x, middle.y + 1 - 0.125 * i, z}});
  }
  for (std::uint32_t i = 0; i < kLeaves; ++i) {
    const std::uint32_t a = 2 * i, b = a + 2, c = a + 3, d = a + 1;
    if (turned)
      mesh.triangles.insert(mesh.triangles.end(), {{c, b, a}, {d, c, a}});
    else
      mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
  }
  return mesh;
}

TriangleMesh screen_front() { return screen({1.75, -0.25, -0.5}, false); }
TriangleMesh screen_back() { return screen({-1.75, 0, -0.75}, true); }

/// Mountains over a square of 102 x 102 whole numbers, 20808 triangles with flat facets.
TriangleMesh mountains() {
  constexpr double kHalfSide = 51, kHeight = 45, kTenths = 10;
  TriangleMesh mesh = generated("terrain", 20808, 2);
  for (Point3& p : mesh.positions)
    p = {rounded(p.x * kHalfSide, 1), rounded(p.y * kHeight, kTenths), rounded(p.z * kHalfSide, 1)};
  mesh.normals.clear();
  mesh.texcoords.clear();
  return mesh;
}

struct MeshFile {
  const char* name;
  TriangleMesh (*make)();
};

constexpr std::initializer_list<MeshFile> kFiles = {{"boulder.msh", boulder},
                                                    {"cloth.msh", cloth},
                                                    {"knot.msh", knot},
                                                    {"mountains.msh", mountains},
                                                    {"screen-back.msh", screen_back},
                                                    {"screen-front.msh", screen_front}};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: make_pa3_meshes DIR\n";
    return 2;
  }
  try {
    for (const MeshFile& file : kFiles) plumb::write_msh(file.make(), std::filesystem::path(argv[1]) / file.name);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
  return 0;
}

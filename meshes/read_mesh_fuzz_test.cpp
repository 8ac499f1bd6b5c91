#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "meshes/mesh_files_for_tests.h"

namespace plumb {
namespace {

/// Changes one to four places: a bit, a byte, a removed, repeated or moved stretch, a word that has caused trouble.
std::string mutated(std::string bytes, std::mt19937& random) {
  static const std::vector<std::string> kWords = {"-1",         "0",
                                                  "4294967295", "2000000000",
                                                  "nan",        "-inf",
                                                  "1e39",       "1e-46",
                                                  "1e999",      " ",
                                                  "\n",         "/",
                                                  "//",         "#",
                                                  "f",          "v",
                                                  "3",          "\xff\xff\xff\xff",
                                                  "vertices",   "element vertex 7\n",
                                                  "BINARY",     std::string(3, '\0')};
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
  for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
    const std::size_t at = below(bytes.size()), length = std::min<std::size_t>(below(20), bytes.size() - at);
    switch (below(7)) {
      case 0:
        if (!bytes.empty()) bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
        break;
      case 1:
        if (!bytes.empty()) bytes[at] = static_cast<char>(random());
        break;
      case 2:
        bytes.erase(at, length);
        break;
      case 3:
        bytes.insert(at, bytes.substr(at, length));
        break;
      case 4:
        bytes.insert(below(bytes.size()), bytes.substr(at, length));
        break;
      case 5:
        bytes.insert(at, kWords[below(kWords.size())]);
        break;
      default:
        bytes.replace(at, length, kWords[below(kWords.size())]);
        break;
    }
    if (below(40) == 0) bytes.resize(below(bytes.size()));
  }
  return bytes;
}

bool is_sound(const TriangleMesh& mesh) {
  const std::size_t vertices = mesh.positions.size();
  const auto in_range = [&](const auto& t) { return t[0] < vertices && t[1] < vertices && t[2] < vertices; };
  return std::all_of(mesh.positions.begin(), mesh.positions.end(), is_finite<Point3>) &&
         std::all_of(mesh.triangles.begin(), mesh.triangles.end(), in_range) &&
         std::all_of(mesh.normals.begin(), mesh.normals.end(), is_finite<Normal3>) &&
         (mesh.normals.empty() || mesh.normals.size() == vertices) &&
         std::all_of(mesh.texcoords.begin(), mesh.texcoords.end(),
                     [](const TexCoord& t) { return std::isfinite(t.u) && std::isfinite(t.v); }) &&
         (mesh.texcoords.empty() || mesh.texcoords.size() == vertices);
}

/// Reads `cases` mutations. Each must give a sound mesh or an InputError; any other exception fails the test.
/// Both outcomes must have happened often enough to mean something.
void fuzz(const std::string& name, const std::string& valid, int cases) {
  ASSERT_FALSE(read_text(name, valid).triangles.empty());
  std::mt19937 random(20111);
  int meshes = 0, errors = 0;
  for (int i = 0; i < cases; ++i) {
    const std::string bytes = mutated(valid, random);
    try {
      ASSERT_TRUE(is_sound(read_text(name, bytes)))
          << "case " << i << " of " << name << ": " << ::testing::PrintToString(bytes);
      ++meshes;
    } catch (const InputError&) {
      ++errors;
    }
  }
  EXPECT_EQ(meshes + errors, cases);
  EXPECT_GT(meshes, cases / 50);
  EXPECT_GT(errors, cases / 10);
}

TEST(ReadMeshFuzz, Msh) {
  fuzz("fuzz.msh",
       "4\n2\nvertices\n0\n0\n0\n1\n0\n0\n1\n1\n0\n0\n1\n0."
       "5\ntriangles\n0\n1\n2\n0\n2\n3\nnormals\n0\n0\n1\n0\n0\n1\n0\n0\n1\n0\n0\n1\n"
       "texcoords\n0\n0\n1\n0\n1\n1\n0\n1\n",
       5000);
}

TEST(ReadMeshFuzz, PlyText) {
  std::string valid =
      "ply\nformat ascii 1.0\nelement vertex 40\nproperty float x\nproperty float y\nproperty float z\nproperty uchar "
      "red\nelement face 40\nproperty list uchar int vertex_indices\nend_header\n";
  // Many numbers, so that most changes do not fall into the header.
  for (int i = 0; i < 40; ++i) valid += std::to_string(i) + " -2.5 " + std::to_string(i * i) + " 255\n";
  for (int i = 0; i < 40; ++i) valid += "3 0 1 " + std::to_string(i) + "\n";
  fuzz("fuzz.ply", valid, 1000);
}

TEST(ReadMeshFuzz, PlyBinary) {
  std::string valid =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty double "
      "z\nproperty float "
      "u\nproperty float v\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n";
  for (int i = 0; i < 4; ++i) valid += raw(float(i)) + raw(.5f) + raw(1. / (1 + i)) + raw(0.f) + raw(1.f);
  valid += "\4" + raw(0) + raw(1) + raw(2) + raw(3) + "\3" + raw(0) + raw(1) + raw(2);
  fuzz("fuzz.ply", valid, 1000);
}

TEST(ReadMeshFuzz, OffText) {
  fuzz("fuzz.off", "NOFF\n4 2 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 .5 0 1 0\n4 0 1 2 3\n3 0 1 2 255 0 0\n",
       1000);
}

TEST(ReadMeshFuzz, OffBinary) {
  std::string valid = "OFF BINARY\n" + raw(3u) + raw(2u) + raw(0u);
  for (int i = 0; i < 9; ++i) valid += raw(float(i));
  for (int face = 0; face < 2; ++face) valid += raw(3u) + raw(0u) + raw(1u) + raw(2u);
  fuzz("fuzz.off", valid, 1000);
}

TEST(ReadMeshFuzz, Obj) {
  fuzz("fuzz.obj",
       "mtllib x.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 .5\nvt 0 0\nvt 1 1\nvn 0 0 1\nvn 0 1 0\nusemtl a\nf 1/1/1 2/2/1 "
       "3/1/2\nf 1//1 3//2 "
       "4//2\nf -4 -3 -2 -1\n",
       1000);
}

TEST(ReadMeshFuzz, StlText) {
  fuzz("fuzz.stl",
       "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nfacet "
       "normal 0 0 1\nouter "
       "loop\nvertex 1 0 0\nvertex 1 1 .5\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n",
       1000);
}

TEST(ReadMeshFuzz, StlBinary) {
  std::string valid(80, ' ');
  valid += raw(2u);
  for (int i = 0; i < 24; ++i) valid += raw(float(i * i)) + (i % 12 == 11 ? raw(std::uint16_t{0}) : "");
  fuzz("fuzz.stl", valid, 1000);
}

}  // namespace
}  // namespace plumb

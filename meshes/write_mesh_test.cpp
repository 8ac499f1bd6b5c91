#include "meshes/write_mesh.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "meshes/formats/file_bytes.h"
#include "meshes/generators/icosphere.h"
#include "meshes/mesh_files_for_tests.h"

namespace plumb {
namespace {

/// A file name, and whether the format's text is asked for.
struct Variant {
  const char* name;
  bool text;
  bool is_stl() const { return std::string(name).ends_with(".stl"); }
};
constexpr Variant kVariants[] = {{"m.msh", false}, {"m.obj", false}, {"b.ply", false}, {"t.ply", true},
                                 {"b.off", false}, {"t.off", true},  {"b.stl", false}, {"t.stl", true}};

/// Finite floats of all exponents, denormal ones too; as doubles.
double any_float(std::mt19937_64& random) {
  for (;;) {
    const float x = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (std::isfinite(x)) return double{x};
  }
}

/// Triangles of any shape, degenerate ones and repeated ones too, that use every vertex.
TriangleMesh any_mesh(std::mt19937_64& random, std::uint32_t vertices, bool normals, bool texcoords) {
  TriangleMesh mesh;
  const auto x = [&] { return any_float(random); };
  for (std::uint32_t i = 0; i < vertices; ++i) {
    mesh.positions.push_back({x(), x(), x()});
    if (normals) mesh.normals.push_back({x(), x(), x()});
    if (texcoords) mesh.texcoords.push_back({x(), x()});
    const auto any = [&] { return static_cast<std::uint32_t>(random() % vertices); };
    mesh.triangles.push_back({i, any(), any()});
    mesh.triangles.push_back({any(), any(), any()});
  }
  if (vertices > 1) mesh.triangles.push_back({0, 0, 1});
  if (vertices > 1) mesh.triangles.push_back({1, 1, 1});
  return mesh;
}

/// The corners of all triangles, in order.
std::vector<Point3> soup(const TriangleMesh& mesh) {
  std::vector<Point3> corners;
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) corners.push_back(mesh.positions[vertex]);
  }
  return corners;
}

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

template <class Triple>
void expect_same_bits(const std::vector<Triple>& a, const std::vector<Triple>& b, const char* name) {
  ASSERT_EQ(a.size(), b.size()) << name;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis)
      ASSERT_TRUE(same_bits(a[i][axis], b[i][axis])) << name << " " << std::hexfloat << a[i][axis] << " " << b[i][axis];
  }
}

/// Everything the same, but for STL, where the soup of triangles is.
void expect_kept(const TriangleMesh& mesh, const TriangleMesh& read, const Variant& variant) {
  if (variant.is_stl()) {
    EXPECT_EQ(soup(read), soup(mesh)) << variant.name;
    return;
  }
  EXPECT_EQ(read.triangles, mesh.triangles) << variant.name;
  expect_same_bits(read.positions, mesh.positions, variant.name);
  expect_same_bits(read.normals, mesh.normals, variant.name);
  EXPECT_EQ(read.texcoords, mesh.texcoords) << variant.name;
}

TEST(WriteMesh, ARoundTripKeepsFloatsOfAllExponents) {
  std::mt19937_64 random(42);
  int trips = 0;
  for (const std::uint32_t vertices : {1u, 2u, 7u, 400u}) {
    for (int attributes = 0; attributes < 4; ++attributes) {
      const TriangleMesh mesh = any_mesh(random, vertices, attributes % 2 == 1, attributes / 2 == 1);
      for (const Variant& variant : kVariants) {
        const auto file = test_file(variant.name);
        const MeshLosses losses = write_mesh(mesh, file, {.text = variant.text, .progress = {}});
        EXPECT_EQ(losses.sentences.empty(), !variant.is_stl()) << variant.name;
        expect_kept(mesh, read_mesh(file), variant);
        ++trips;
      }
    }
  }
  EXPECT_EQ(trips, 4 * 4 * 8);
}

TEST(WriteMesh, AnEmptyMeshAndUnusedVerticesSurvive) {
  TriangleMesh points;
  points.positions = {{1, 2, 3}, {4, 5, 6}};
  for (const Variant& variant : kVariants) {
    const auto file = test_file(variant.name);
    EXPECT_TRUE(write_mesh({}, file, {.text = variant.text, .progress = {}}).sentences.empty());
    EXPECT_EQ(read_mesh(file), TriangleMesh{}) << variant.name;
    write_mesh(points, file, {.text = variant.text, .progress = {}});
    EXPECT_EQ(read_mesh(file), variant.is_stl() ? TriangleMesh{} : points) << variant.name;
  }
}

TEST(WriteMesh, AnMshWithCrlfReadsTheSame) {
  std::mt19937_64 random(7);
  const TriangleMesh mesh = any_mesh(random, 50, true, true);
  const auto file = test_file("lf.msh");
  write_mesh(mesh, file);
  std::string crlf;
  for (const char c : file_bytes(file)) crlf.append(c == '\n' ? "\r\n" : std::string(1, c));
  MeshNotes notes;
  EXPECT_EQ(read_mesh(write_test_file("crlf.msh", crlf), &notes), mesh);
  EXPECT_EQ(notes.format, "MSH, text with CRLF");
}

TEST(WriteMesh, RoundsDoublesToTheNearestFloatAndSaysSo) {
  std::mt19937_64 random(99);
  std::uniform_real_distribution<double> any(-1000, 1000);
  TriangleMesh mesh, rounded;
  const auto nearest = [](double x) {
    const volatile float f = static_cast<float>(x);  // GCC 12 drops the rounding where it vectorises
    return double{f};
  };
  for (std::uint32_t i = 0; i < 300; ++i) {
    const double x = any(random), y = any(random), z = any(random);
    mesh.positions.push_back({x, y, z});
    mesh.normals.push_back({z, x, y});
    mesh.texcoords.push_back({y, x});
    rounded.positions.push_back({nearest(x), nearest(y), nearest(z)});
    rounded.normals.push_back({nearest(z), nearest(x), nearest(y)});
    rounded.texcoords.push_back({nearest(y), nearest(x)});
    mesh.triangles.push_back({i, (i * 7 + 1) % 300, (i * 11 + 5) % 300});
  }
  rounded.triangles = mesh.triangles;
  for (const Variant& variant : kVariants) {
    const auto file = test_file(variant.name);
    const MeshLosses losses = write_mesh(mesh, file, {.text = variant.text, .progress = {}});
    const bool is_msh = std::string(variant.name) == "m.msh";
    expect_kept(is_msh ? mesh : rounded, read_mesh(file), variant);
    if (is_msh) {
      EXPECT_TRUE(losses.sentences.empty());
      continue;
    }
    // Half the distance of floats from 512 to 1024.
    EXPECT_EQ(losses.sentences.at(0), "900 of 900 coordinates rounded to single precision, by at most 3.1e-05")
        << variant.name;
    if (variant.is_stl()) continue;
    EXPECT_EQ(losses.sentences.at(1), "900 of 900 numbers of normals rounded to single precision, by at most 3.1e-05");
    EXPECT_EQ(losses.sentences.at(2),
              "600 of 600 numbers of texture coordinates rounded to single precision, by at most 3.1e-05");
  }
}

TEST(WriteMesh, SaysWhatStlAndObjCannotCarry) {
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 2, 2}},
                    {{0, 1, 2}},
                    std::vector<Normal3>(4, {0, 0, 1}),
                    std::vector<TexCoord>(4, {0.5, 0})};
  EXPECT_EQ(write_mesh(mesh, test_file("m.stl")).sentences,
            (std::vector<std::string>{
                "normals of 4 vertices: STL has none of vertices", "texture coordinates of 4 vertices: STL has none",
                "1 vertex of no triangle: STL holds triangles alone",
                "which triangles share the 4 vertices, and their order: STL repeats them at 3 corners, and readers "
                "join what lies at one point"}));
  EXPECT_EQ(write_mesh(mesh, test_file("m.obj")).sentences,
            (std::vector<std::string>{
                "normals and texture coordinates of 1 vertex of no triangle: OBJ gives them to the corners of faces"}));
  EXPECT_TRUE(write_mesh(mesh, test_file("m.ply")).sentences.empty());
  EXPECT_TRUE(write_mesh(mesh, test_file("m.off")).sentences.empty());
}

TEST(WriteMesh, StlHasTheNormalsOfTheWinding) {
  const float huge = 1e30F, tiny = 1e-40F;
  for (const double size : {1.0, double{huge}, double{tiny}}) {
    const auto file = test_file("n.stl");
    write_mesh({{{0, 0, 0}, {size, 0, 0}, {0, size, 0}}, {{0, 1, 2}, {0, 2, 1}, {0, 0, 1}}, {}, {}}, file,
               {.text = true, .progress = {}});
    const std::string text = file_bytes(file);
    EXPECT_NE(text.find("facet normal 0 0 1\n"), std::string::npos) << text;
    EXPECT_NE(text.find("0 -1\nouter"), std::string::npos) << text;
    EXPECT_NE(text.find("facet normal 0 0 0\n"), std::string::npos) << text;
  }
}

TEST(WriteMesh, TheSameMeshGivesTheSameBytesAndTellsItsProgress) {
  const TriangleMesh mesh = icosphere(4);
  for (const Variant& variant : kVariants) {
    double last = 0;
    int calls = 0;
    const auto tell = [&](double share) {
      EXPECT_GE(share, last);
      EXPECT_LE(share, 1);
      last = share;
      ++calls;
    };
    write_mesh(mesh, test_file(variant.name), {.text = variant.text, .progress = tell});
    const std::string first = file_bytes(test_file(variant.name));
    write_mesh(mesh, test_file(variant.name), {.text = variant.text, .progress = {}});
    EXPECT_TRUE(first == file_bytes(test_file(variant.name))) << variant.name;
    EXPECT_GT(last, 0.99) << variant.name;
    EXPECT_GT(calls, 500) << variant.name;
  }
}

TEST(WriteMesh, RefusesWhatNoFileCanHold) {
  EXPECT_THROW(write_mesh({}, test_file("m.gltf")), InputError);
  const double infinity = std::numeric_limits<double>::infinity();
  const TriangleMesh large{{{1e39, 0, 0}}, {}, {}, {}}, broken{{{infinity, 0, 0}}, {}, {}, {}};
  for (const Variant& variant : kVariants) {
    const auto file = test_file(std::string("never-") + variant.name);
    EXPECT_THROW(write_mesh(broken, file), std::invalid_argument) << variant.name;
    if (std::string(variant.name) != "m.msh") {
      EXPECT_THROW(write_mesh(large, file), InputError) << variant.name;
    }
    EXPECT_FALSE(std::filesystem::exists(file));
    EXPECT_THROW(write_mesh({}, test_file("no such folder") / variant.name), InputError) << variant.name;
  }
  for (const auto& entry : std::filesystem::directory_iterator(test_file("x").parent_path()))
    EXPECT_NE(entry.path().extension(), ".tmp") << entry.path();
}

}  // namespace
}  // namespace plumb

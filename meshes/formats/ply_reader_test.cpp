#include "meshes/formats/ply_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

#include "meshes/formats/open_mesh_reader.h"
#include "meshes/formats/prepare.h"
#include "meshes/mesh_files_for_tests.h"

namespace plumb {
namespace {

/// How the numbers of a file made for a test are written.
struct Variant {
  std::string format, coordinate, length, index;
};

/// Appends numbers to a PLY body in one of the three forms.
class Body {
 public:
  explicit Body(std::string format) : format_(std::move(format)) {}

  void put(const std::string& type, double number) {
    if (format_ == "ascii") {
      char text[32];
      std::snprintf(text, sizeof text, "%.17g ", number);
      bytes += text;
    } else if (type == "float") {
      append(static_cast<float>(number));
    } else if (type == "double") {
      append(number);
    } else if (type == "uchar") {
      append(static_cast<std::uint8_t>(number));
    } else if (type == "short") {
      append(static_cast<std::int16_t>(number));
    } else {
      append(static_cast<std::uint32_t>(number));
    }
  }

  std::string bytes;

 private:
  template <class Number>
  void append(Number number) {
    std::string added = raw(number);
    if (format_ == "binary_big_endian") std::reverse(added.begin(), added.end());
    bytes += added;
  }

  std::string format_;
};

/// A file of 60 vertices with normals, texture coordinates and, where `odd`, properties that nobody needs, and of 90
/// faces, some of them polygons, some naming a vertex twice.
std::string random_file(const Variant& variant, bool odd, std::uint32_t seed, bool polygons = true) {
  std::mt19937 random(seed);
  const auto number = [&] { return static_cast<double>(static_cast<float>(random()) / 4294967296.F - .5F); };
  std::string header = "ply\nformat " + variant.format + " 1.0\ncomment made for a test\n";
  if (odd) header += "element camera 2\nproperty list uchar short k\nproperty double f\n";
  header += "element vertex 60\n";
  const std::string c = variant.coordinate;
  if (odd) header += "property uchar red\n";
  header += "property " + c + " x\nproperty " + c + " y\nproperty " + c + " z\nproperty float nx\nproperty float ny\n";
  header += "property float nz\nproperty " + c + " s\nproperty " + c + " t\n";
  header += "element face 90\nproperty list " + variant.length + " " + variant.index + " vertex_indices\n";
  if (odd) header += "property short material\n";
  Body body(variant.format);
  for (int i = 0; i < (odd ? 2 : 0); ++i) {
    body.put("uchar", 2);
    for (int k = 0; k < 2; ++k) body.put("short", i + k);
    body.put("double", .5);
  }
  for (int i = 0; i < 60; ++i) {
    if (odd) body.put("uchar", 200);
    for (const char* type : {c.c_str(), c.c_str(), c.c_str(), "float", "float", "float", c.c_str(), c.c_str()})
      body.put(type, type == std::string("short") ? std::trunc(64 * number()) : number());
  }
  for (int i = 0; i < 90; ++i) {
    const auto corners = polygons && random() % 4 == 0 ? 3 + random() % 4 : 3;
    body.put(variant.length, static_cast<double>(corners));
    for (unsigned k = 0; k < corners; ++k) body.put(variant.index, static_cast<double>(random() % 60));
    if (odd) body.put("short", i);
  }
  return header + "end_header\n" + body.bytes;
}

/// What becomes of a file: a mesh with its notes, or an error's text.
struct Outcome {
  TriangleMesh mesh;
  std::string format, error;
  std::vector<std::string> sentences;
  std::size_t polygons = 0;
  friend bool operator==(const Outcome&, const Outcome&) = default;
};

template <class Read>
Outcome outcome_of(const Read& read) {
  MeshNotes notes;
  try {
    TriangleMesh mesh = read(notes);
    return {std::move(mesh), notes.format, "", notes.sentences, notes.polygons};
  } catch (const InputError& error) {
    return {{}, "", error.what(), {}, 0};
  }
}

Outcome read_straight(const std::string& content) {
  return outcome_of([&](MeshNotes& notes) { return read_ply(content, "m.ply", notes); });
}

/// The way that text takes. It reads binary files as well, and so the two can be compared on the same bytes.
Outcome read_through_open_mesh(const std::string& content) {
  return outcome_of(
      [&](MeshNotes& notes) { return read_with_open_mesh(prepare_ply(content, "m.ply"), "m.ply", notes); });
}

/// Both byte orders, and forms that are copied as well as forms that are taken number by number.
std::vector<Variant> binary_variants() {
  std::vector<Variant> variants;
  for (const char* format : {"binary_little_endian", "binary_big_endian"}) {
    for (const char* coordinate : {"float", "double", "short"}) {
      for (const auto& [length, index] :
           {std::pair{"uchar", "int"}, std::pair{"uint", "uint"}, std::pair{"short", "uchar"}})
        variants.push_back({format, coordinate, length, index});
    }
  }
  return variants;
}

TEST(PlyReader, ABinaryFileGivesTheMeshOfItsTextTwinThroughOpenMesh) {
  int files = 0;
  for (const Variant& variant : binary_variants()) {
    const Variant text_variant = {"ascii", variant.coordinate, variant.length, variant.index};
    for (const bool odd : {false, true}) {
      const Outcome binary = read_straight(random_file(variant, odd, 7));
      const Outcome text = read_straight(random_file(text_variant, odd, 7));
      ASSERT_EQ(binary.error, "");
      ASSERT_EQ(binary.mesh.positions.size(), 60u);
      ASSERT_EQ(binary.mesh.normals.size(), 60u);
      ASSERT_EQ(binary.mesh.texcoords.size(), 60u);
      ASSERT_GT(binary.mesh.triangles.size(), 100u);
      EXPECT_EQ(binary.mesh, text.mesh);
      EXPECT_EQ(text.format, "PLY, text");
      EXPECT_EQ(binary.sentences, text.sentences);
      EXPECT_EQ(binary.sentences.size(), (odd ? 3u : 0u));
      EXPECT_EQ(binary.polygons, text.polygons);
      EXPECT_GT(binary.polygons, 0u);
      ++files;
    }
  }
  EXPECT_EQ(files, 36);
}

/// Changes one to three bits, bytes or numbers, or the length.
std::string damaged(std::string bytes, std::mt19937& random) {
  for (unsigned changes = 1 + static_cast<unsigned>(random() % 3); changes > 0; --changes) {
    const std::size_t at = random() % bytes.size();
    switch (random() % 6) {
      case 0:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
        break;
      case 1:
        bytes[at] = static_cast<char>(random());
        break;
      case 2:
        bytes.replace(at, std::min<std::size_t>(4, bytes.size() - at), raw(0xffffffffU));
        break;
      case 3:
        bytes.replace(at, std::min<std::size_t>(4, bytes.size() - at), raw(std::numeric_limits<float>::infinity()));
        break;
      case 4:
        bytes.insert(at, 1, '\0');
        break;
      default:
        bytes.erase(at, random() % 2 == 0 ? 1 : bytes.size());
    }
    if (bytes.empty()) return "p";
  }
  return bytes;
}

TEST(PlyReader, ReadsAndRefusesDamagedFilesAsTheWayThroughOpenMeshDoes) {
  std::mt19937 random(20112);
  int cases = 0, meshes = 0, errors = 0;
  for (const Variant& variant : binary_variants()) {
    for (const bool odd : {false, true}) {
      for (const bool polygons : {false, true}) {
        const std::string whole = random_file(variant, odd, 9, polygons);
        ASSERT_EQ(read_straight(whole), read_through_open_mesh(whole));
        for (int i = 0; i < 300; ++i, ++cases) {
          const std::string bytes = damaged(whole, random);
          const Outcome ours = read_straight(bytes);
          ASSERT_EQ(ours, read_through_open_mesh(bytes))
              << ours.error << ", case " << i << " of " << variant.format << " " << variant.coordinate << " "
              << variant.index << ": " << ::testing::PrintToString(bytes);
          ++(ours.error.empty() ? meshes : errors);
        }
      }
    }
  }
  EXPECT_EQ(cases, 18 * 4 * 300);
  EXPECT_GT(meshes, cases / 12);
  EXPECT_GT(errors, cases / 4);
}

TEST(PlyReader, RefusesAFileCutAtAnyByte) {
  int cuts = 0;
  for (const Variant& variant : binary_variants()) {
    const std::string whole = random_file(variant, false, 11);
    for (std::size_t length = 0; length < whole.size(); ++length, ++cuts) {
      const Outcome outcome = read_straight(whole.substr(0, length));
      ASSERT_NE(outcome.error, "") << variant.format << " cut at " << length;
      ASSERT_EQ(outcome.error, read_through_open_mesh(whole.substr(0, length)).error);
    }
  }
  EXPECT_GT(cuts, 18 * 1500);
}

/// GCC 12 drops a conversion to float and back from some loops that it vectorises. Enough vertices for it to do so, and
/// doubles of which none is a float.
TEST(PlyReader, RoundsLongListsOfDoubles) {
  constexpr int kVertices = 1001;
  std::string content = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(kVertices) +
                        "\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
  for (int i = 0; i < kVertices; ++i) content += raw(i + .1) + raw(i + .2) + raw(i + .3);
  const Outcome outcome = read_straight(content);
  ASSERT_EQ(outcome.mesh.positions.size(), std::size_t{kVertices});
  for (int i = 0; i < kVertices; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const volatile float rounded = static_cast<float>(i + (axis + 1) / 10.);
      ASSERT_EQ(outcome.mesh.positions[static_cast<std::size_t>(i)][axis], double{rounded}) << i;
    }
  }
  EXPECT_EQ(outcome.sentences,
            (std::vector<std::string>{"3003 numbers are rounded to single precision, which holds fewer digits"}));
}

TEST(PlyReader, AnEmptyMeshNeedsNoFaces) {
  const std::string start =
      "ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\n";
  for (const char* faces : {"", "element face 0\nproperty list uchar int vertex_indices\n", "element face 0\n"}) {
    const Outcome outcome = read_straight(start + faces + "end_header\n");
    EXPECT_EQ(outcome.error, "");
    EXPECT_EQ(outcome.mesh, TriangleMesh{});
    EXPECT_EQ(outcome, read_through_open_mesh(start + faces + "end_header\n"));
  }
}

}  // namespace
}  // namespace plumb

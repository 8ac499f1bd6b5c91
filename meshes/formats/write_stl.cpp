// Not through OpenMesh: its STL writer refuses a mesh that has vertex normals, and writes nan or zeros as the normals
// of facets that are degenerate, very large or very small.
#include "meshes/formats/write_stl.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <string>

#include "meshes/formats/write_progress.h"

namespace plumb {
namespace {

static_assert(std::endian::native == std::endian::little, "the numbers below are copied in the machine's byte order");

using Triple = std::array<float, 3>;
/// The normal and the three corners.
using Facet = std::array<Triple, 4>;

Triple single(const Vec3& v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }
Vec3 widened(const Triple& t) { return {double{t[0]}, double{t[1]}, double{t[2]}}; }

/// Of the corners as the file has them. In double precision the square of no float overflows or vanishes, nor does the
/// square of a product of two.
Triple unit_normal(const Facet& facet) {
  const Vec3 a = widened(facet[1]), u = widened(facet[2]) - a, v = widened(facet[3]) - a;
  const Vec3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
  return length > 0 ? single({n.x / length, n.y / length, n.z / length}) : Triple{};
}

Facet facet_of(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  Facet facet;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point3& p = mesh.positions[triangle[i]];
    facet[i + 1] = single({p.x, p.y, p.z});
  }
  facet[0] = unit_normal(facet);
  return facet;
}

void append(std::string& text, const char* keyword, const Triple& triple) {
  text += keyword;
  for (const float x : triple) {
    char digits[32];
    text.append(" ").append(digits, std::to_chars(digits, digits + sizeof digits, x).ptr);
  }
  text += '\n';
}

void put_text(const Facet& facet, std::string& text, std::ostream& out) {
  text.clear();
  append(text, "facet normal", facet[0]);
  text += "outer loop\n";
  for (std::size_t i = 1; i < 4; ++i) append(text, "vertex", facet[i]);
  text += "endloop\nendfacet\n";
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
}

void put_binary(const Facet& facet, std::ostream& out) {
  std::array<char, 50> bytes{};  // the last two are an attribute that nobody agrees on
  std::memcpy(bytes.data(), &facet, sizeof facet);
  out.write(bytes.data(), bytes.size());
}

}  // namespace

void write_stl(const TriangleMesh& mesh, bool text, std::ostream& out, const std::function<void(double)>& progress) {
  WriteProgress bar(progress, mesh.triangles.size());
  std::string words = "binary STL";  // must not begin with solid, by which text is known
  words.resize(80, ' ');
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  words.append(reinterpret_cast<const char*>(&count), sizeof count);
  if (text) words = "solid mesh\n";
  out.write(words.data(), static_cast<std::streamsize>(words.size()));
  for (const auto& triangle : mesh.triangles) {
    const Facet facet = facet_of(mesh, triangle);
    text ? put_text(facet, words, out) : put_binary(facet, out);
    bar.step();
  }
  if (text) out << "endsolid mesh\n";
}

}  // namespace plumb

#include "meshes/formats/write_msh.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

#include "renderer/math/input_error.h"

namespace plumb {
namespace {

void refuse_broken(const TriangleMesh& mesh) {
  const std::size_t vertices = mesh.positions.size();
  if (!mesh.normals.empty() && mesh.normals.size() != vertices)
    throw std::invalid_argument("normals must be one a vertex");
  if (!mesh.texcoords.empty() && mesh.texcoords.size() != vertices) {
    throw std::invalid_argument("texcoords must be one a vertex");
  }
  const bool finite = std::all_of(mesh.positions.begin(), mesh.positions.end(), is_finite<Point3>) &&
                      std::all_of(mesh.normals.begin(), mesh.normals.end(), is_finite<Normal3>) &&
                      std::all_of(mesh.texcoords.begin(), mesh.texcoords.end(),
                                  [](const TexCoord& t) { return std::isfinite(t.u) && std::isfinite(t.v); });
  if (!finite) throw std::invalid_argument("a number of the mesh is not finite");
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t index : triangle) {
      if (index >= vertices) throw std::invalid_argument("a vertex index of the mesh is out of range");
    }
  }
}

template <class Number>
void append_line(std::string& text, Number value) {
  char digits[32];  // the longest double is -2.2250738585072014e-308, 24 bytes
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
  text.append(digits, end).push_back('\n');
}

template <class Triple>
void append_triples(std::string& text, const char* keyword, const std::vector<Triple>& triples) {
  text.append(keyword).push_back('\n');
  for (const Triple& t : triples) {
    append_line(text, t.x);
    append_line(text, t.y);
    append_line(text, t.z);
  }
}

std::string msh_text(const TriangleMesh& mesh) {
  std::string text;
  append_line(text, mesh.positions.size());
  append_line(text, mesh.triangles.size());
  append_triples(text, "vertices", mesh.positions);
  text += "triangles\n";
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t index : triangle) append_line(text, index);
  }
  if (!mesh.texcoords.empty()) text += "texcoords\n";
  for (const TexCoord& t : mesh.texcoords) {
    append_line(text, t.u);
    append_line(text, t.v);
  }
  if (!mesh.normals.empty()) append_triples(text, "normals", mesh.normals);
  return text;
}

/// A name that no other thread and no other process writes to.
std::filesystem::path temporary_beside(const std::filesystem::path& file) {
  static std::atomic<unsigned> serial = 0;
  std::filesystem::path temporary = file;
  std::string ending = ".";
  ending.append(std::to_string(getpid())).append("-").append(std::to_string(serial++)).append(".tmp");
  return temporary += ending;
}

}  // namespace

void write_msh(const TriangleMesh& mesh, const std::filesystem::path& file) {
  refuse_broken(mesh);
  const std::string text = msh_text(mesh);
  const std::filesystem::path temporary = temporary_beside(file);
  std::ofstream out(temporary, std::ios::binary);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(temporary, file, error);
  if (!out || error) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw InputError({file.string()},
                     "the mesh cannot be written; expected a place for a file in a folder that exists");
  }
}

}  // namespace plumb

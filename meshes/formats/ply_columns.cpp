#include "meshes/formats/ply_columns.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

#include "renderer/math/single_precision.h"

namespace plumb {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied in the machine's byte order");

/// A number of the file, whose byte order is the machine's (little-endian) or the other one.
template <class Number, bool kBigEndian>
Number load(const char* at) {
  std::array<char, sizeof(Number)> raw;
  std::memcpy(raw.data(), at, sizeof raw);
  if constexpr (kBigEndian) std::reverse(raw.begin(), raw.end());
  Number number;
  std::memcpy(&number, raw.data(), sizeof number);
  return number;
}

/// Where the numbers of one thing (a position, a normal) stand in each vertex, and their one type.
template <std::size_t kCount>
struct Places {
  std::array<std::size_t, kCount> offsets;
  PlyType type;
};

/// nullopt if the numbers from slot `first` on have different types.
template <std::size_t kCount>
std::optional<Places<kCount>> places_of(const PlyLayout& layout, std::size_t first) {
  const std::vector<PlyProperty>& properties = layout.vertex->properties;
  Places<kCount> places{{}, properties[*layout.sources[first]].type};
  for (std::size_t i = 0; i < kCount; ++i) {
    const std::size_t source = *layout.sources[first + i];
    if (properties[source].type != places.type) return std::nullopt;
    for (std::size_t p = 0; p < source; ++p) places.offsets[i] += size_of(properties[p].type);
  }
  return places;
}

Point3 value_of(std::type_identity<Point3>, const std::array<double, 3>& n) { return {n[0], n[1], n[2]}; }
Normal3 value_of(std::type_identity<Normal3>, const std::array<double, 3>& n) { return {n[0], n[1], n[2]}; }
TexCoord value_of(std::type_identity<TexCoord>, const std::array<double, 2>& n) { return {n[0], n[1]}; }

/// Copies one list; see copy_ply_vertices.
template <class Number, bool kBigEndian, std::size_t kCount, class Value>
std::optional<std::size_t> copy_numbers(const Places<kCount>& places, const char* body, std::size_t stride,
                                        std::vector<Value>& values) {
  std::size_t rounded = 0;
  bool all_finite = true;
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::array<double, kCount> numbers;
    for (std::size_t k = 0; k < kCount; ++k) {
      const Number number = load<Number, kBigEndian>(body + i * stride + places.offsets[k]);
      const double single = std::is_same_v<Number, float> ? double{number} : rounded_to_single(number);
      all_finite &= std::isfinite(single);
      rounded += single != number;
      numbers[k] = single;
    }
    values[i] = value_of(std::type_identity<Value>(), numbers);
  }
  return all_finite ? std::optional(rounded) : std::nullopt;
}

template <std::size_t kCount, class Value>
std::optional<std::size_t> copy_list(const PlyHeader& header, const PlyLayout& layout, std::size_t first,
                                     const char* body, std::size_t stride, std::vector<Value>& values) {
  if (values.empty()) return 0;
  const auto places = places_of<kCount>(layout, first);
  if (!places) return std::nullopt;
  const bool is_big = header.format == PlyFormat::kBigEndian;
  if (places->type == PlyType::kFloat) {
    return is_big ? copy_numbers<float, true>(*places, body, stride, values)
                  : copy_numbers<float, false>(*places, body, stride, values);
  }
  if (places->type == PlyType::kDouble) {
    return is_big ? copy_numbers<double, true>(*places, body, stride, values)
                  : copy_numbers<double, false>(*places, body, stride, values);
  }
  return std::nullopt;
}

template <class Length, bool kBigEndian>
std::size_t copy_triangles(std::string_view body, std::uint32_t faces, std::uint32_t vertices, TriangleMesh& mesh) {
  constexpr std::size_t kSize = sizeof(Length) + 3 * sizeof(std::uint32_t);
  const std::size_t most = std::min<std::size_t>(faces, body.size() / kSize);
  std::size_t taken = 0;
  for (; taken < most; ++taken) {
    const char* const at = body.data() + taken * kSize;
    if (load<Length, kBigEndian>(at) != 3) break;
    std::array<std::uint32_t, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = load<std::uint32_t, kBigEndian>(at + sizeof(Length) + 4 * k);
    if (std::max({corners[0], corners[1], corners[2]}) >= vertices) break;
    mesh.triangles.push_back(corners);
  }
  return taken * kSize;
}

}  // namespace

std::optional<std::size_t> copy_ply_vertices(const PlyHeader& header, const PlyLayout& layout, std::string_view body,
                                             TriangleMesh& mesh) {
  const std::optional<std::size_t> stride = fixed_size_of(*layout.vertex);
  if (!stride || body.size() / *stride < layout.vertex->count) return std::nullopt;
  const auto positions = copy_list<3>(header, layout, 0, body.data(), *stride, mesh.positions);
  const auto normals = copy_list<3>(header, layout, kPlyNormal, body.data(), *stride, mesh.normals);
  const auto texcoords = copy_list<2>(header, layout, kPlyTexcoord, body.data(), *stride, mesh.texcoords);
  if (!positions || !normals || !texcoords) return std::nullopt;
  return *positions + *normals + *texcoords;
}

std::size_t copy_ply_triangles(const PlyHeader& header, const PlyLayout& layout, std::string_view body,
                               std::uint32_t faces, TriangleMesh& mesh) {
  if (!layout.corners || layout.face->properties.size() != 1) return 0;
  const PlyProperty& list = layout.face->properties[0];
  if (list.type != PlyType::kInt32 && list.type != PlyType::kUint32) return 0;
  // Larger than an int holds is wrong, and so is what is negative as one, in either type.
  const std::uint32_t vertices = std::min(layout.vertex->count, std::uint32_t{0x80000000});
  const bool is_big = header.format == PlyFormat::kBigEndian;
  switch (size_of(*list.count_type)) {
    case 1:
      return is_big ? copy_triangles<std::uint8_t, true>(body, faces, vertices, mesh)
                    : copy_triangles<std::uint8_t, false>(body, faces, vertices, mesh);
    case 4:
      return is_big ? copy_triangles<std::uint32_t, true>(body, faces, vertices, mesh)
                    : copy_triangles<std::uint32_t, false>(body, faces, vertices, mesh);
    default:
      return 0;
  }
}

}  // namespace plumb

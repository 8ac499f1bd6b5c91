#include "meshes/formats/ply_records.h"

#include <cmath>
#include <string>

namespace plumb {

std::array<float, kPlyVertexNumbers> PlyRecords::vertex(std::uint32_t index) {
  const PlyElement& element = *layout_.vertex;
  std::array<float, kPlyVertexNumbers> kept{};
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    const PlyProperty& property = element.properties[p];
    const std::size_t slot = layout_.slot_of(p);
    if (slot == kPlyVertexNumbers) {
      skip(property, element, index);
      continue;
    }
    const float value = static_cast<float>(numbers_.next(property.type));
    if (!std::isfinite(value)) {
      numbers_.fail(std::string(property.name) + " of vertex " + std::to_string(index) +
                    " is not finite; expected a finite number of single precision");
    }
    if (numbers_.is_rounded_to(value)) ++rounded_;
    kept[slot] = value;
  }
  return kept;
}

std::uint32_t PlyRecords::corner_count(std::uint32_t face) {
  const PlyElement& element = *layout_.face;
  const std::uint32_t corners =
      whole(*element.properties[*layout_.corners].count_type, element, face, "the number of corners");
  if (corners < 3) {
    numbers_.fail("face " + std::to_string(face) + " has " + std::to_string(corners) +
                  " corners; expected three or more");
  }
  return corners;
}

std::uint32_t PlyRecords::next_corner(PlyType type, std::uint32_t face) {
  const std::uint32_t vertices = layout_.vertex->count;
  const std::uint32_t vertex = whole(type, *layout_.face, face, "a vertex index");
  if (vertex >= vertices) {
    numbers_.fail("face " + std::to_string(face) + " names vertex " + std::to_string(vertex) +
                  "; expected the index of one of " + std::to_string(vertices) + " vertices");
  }
  return vertex;
}

void PlyRecords::skip(const PlyElement& element, std::uint32_t index) {
  for (const PlyProperty& property : element.properties) skip(property, element, index);
}

void PlyRecords::skip(const PlyProperty& property, const PlyElement& element, std::uint32_t index) {
  std::uint32_t numbers = 1;
  if (property.count_type) numbers = whole(*property.count_type, element, index, "the length of a list");
  for (; numbers > 0; --numbers) numbers_.next(property.type);
}

std::uint32_t PlyRecords::whole(PlyType type, const PlyElement& element, std::uint32_t index, const char* what) {
  const double number = numbers_.next(type);
  if (!(number >= 0 && number <= 0x7fffffff && number == std::floor(number))) {
    numbers_.fail(std::string(element.name) + " " + std::to_string(index) + ": " + what +
                  " is wrong; expected a whole number from 0 to 2147483647");
  }
  return static_cast<std::uint32_t>(number);
}

}  // namespace plumb

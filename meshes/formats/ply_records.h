#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "meshes/formats/ply_layout.h"
#include "meshes/formats/ply_numbers.h"

namespace plumb {

/// Takes the vertices and faces of a PLY file one number at a time, in the order of the file, and checks each.
class PlyRecords {
 public:
  /// The layout must outlive it.
  PlyRecords(const PlyLayout& layout, PlyNumbers numbers) : layout_(layout), numbers_(std::move(numbers)) {}

  /// The numbers of the next vertex, in single precision; zeros where there is no source. `index` is for messages.
  /// Throws InputError for one that is not finite.
  std::array<float, kPlyVertexNumbers> vertex(std::uint32_t index);

  /// Takes the next face: calls begin(number of corners), then corner(vertex) for each. Throws InputError for less than
  /// three corners and for a vertex that does not exist.
  template <class Begin, class Corner>
  void face(std::uint32_t index, const Begin& begin, const Corner& corner) {
    const PlyElement& element = *layout_.face;
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      if (p != layout_.corners) {
        skip(element.properties[p], element, index);
        continue;
      }
      const PlyType type = element.properties[p].type;
      const std::uint32_t corners = corner_count(index);
      begin(corners);
      for (std::uint32_t i = 0; i < corners; ++i) corner(next_corner(type, index));
    }
  }

  /// Passes over the next one of an element that is neither.
  void skip(const PlyElement& element, std::uint32_t index);

  /// How many numbers were rounded so far, in the sense of is_rounded.
  std::size_t rounded() const { return rounded_; }
  PlyNumbers& numbers() { return numbers_; }

 private:
  std::uint32_t corner_count(std::uint32_t face);
  std::uint32_t next_corner(PlyType type, std::uint32_t face);
  void skip(const PlyProperty& property, const PlyElement& element, std::uint32_t index);
  /// The next number, which must be one that an int can hold: OpenMesh reads no other.
  std::uint32_t whole(PlyType type, const PlyElement& element, std::uint32_t index, const char* what);

  const PlyLayout& layout_;
  PlyNumbers numbers_;
  std::size_t rounded_ = 0;
};

}  // namespace plumb

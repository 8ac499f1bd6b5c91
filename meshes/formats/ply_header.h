#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "meshes/formats/text_cursor.h"

namespace plumb {

/// The number types of PLY, under either of their names (char or int8, ...).
enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };

/// The size in bytes, in a binary file.
std::size_t size_of(PlyType type);

struct PlyProperty {
  std::string_view name;
  PlyType type;
  /// The type of the length, for a list.
  std::optional<PlyType> count_type;
};

struct PlyElement {
  std::string_view name;
  std::uint32_t count;
  std::vector<PlyProperty> properties;
  /// Where the header gives the count, for messages.
  std::string_view count_word;

  /// The index of a property; nullopt if there is none of that name.
  std::optional<std::size_t> find(std::string_view property) const;
};

/// The size in bytes of one instance in a binary file; nullopt if it has a list.
std::optional<std::size_t> fixed_size_of(const PlyElement& element);

enum class PlyFormat { kText, kLittleEndian, kBigEndian };

/// What a PLY file says about itself. The views point into the content.
struct PlyHeader {
  PlyFormat format;
  std::vector<PlyElement> elements;
  /// Where the numbers begin.
  std::size_t body;
};

/// Parses from the cursor, which must stand at the begin of the file. Throws InputError with line and
/// column at the first word that is not PLY, and for an element whose count the rest of the file, of
/// `total_bytes` in all, is too short for.
PlyHeader parse_ply_header(TextCursor& cursor, std::size_t total_bytes);

}  // namespace plumb

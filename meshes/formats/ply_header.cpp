#include "meshes/formats/ply_header.h"

#include <algorithm>
#include <array>

namespace plumb {
namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};
constexpr std::array<TypeName, 16> kTypes = {{{"char", PlyType::kInt8},
                                              {"int8", PlyType::kInt8},
                                              {"uchar", PlyType::kUint8},
                                              {"uint8", PlyType::kUint8},
                                              {"short", PlyType::kInt16},
                                              {"int16", PlyType::kInt16},
                                              {"ushort", PlyType::kUint16},
                                              {"uint16", PlyType::kUint16},
                                              {"int", PlyType::kInt32},
                                              {"int32", PlyType::kInt32},
                                              {"uint", PlyType::kUint32},
                                              {"uint32", PlyType::kUint32},
                                              {"float", PlyType::kFloat},
                                              {"float32", PlyType::kFloat},
                                              {"double", PlyType::kDouble},
                                              {"float64", PlyType::kDouble}}};

std::string found(std::string_view word) { return word.empty() ? "the line ends" : quoted(word) + " stands here"; }

void expect(TextCursor& cursor, std::string_view expected) {
  const std::string_view word = cursor.next_in_line();
  if (word != expected) cursor.fail(word, found(word) + "; expected " + std::string(expected));
}

PlyType parse_type(const TextCursor& cursor, std::string_view word) {
  const auto known =
      std::find_if(kTypes.begin(), kTypes.end(), [&](const TypeName& type) { return type.name == word; });
  if (known == kTypes.end()) cursor.fail(word, found(word) + "; expected a number type such as float, uchar or int");
  return known->type;
}

PlyFormat parse_format(TextCursor& cursor) {
  expect(cursor, "format");
  const std::string_view word = cursor.next_in_line();
  const bool is_text = word == "ascii";
  if (!is_text && word != "binary_little_endian" && word != "binary_big_endian") {
    cursor.fail(word, found(word) + "; expected ascii, binary_little_endian or binary_big_endian");
  }
  expect(cursor, "1.0");
  return is_text ? PlyFormat::kText : word == "binary_little_endian" ? PlyFormat::kLittleEndian : PlyFormat::kBigEndian;
}

std::string_view parse_name(TextCursor& cursor) {
  const std::string_view word = cursor.next_in_line();
  if (word.empty()) cursor.fail(word, "the line ends; expected a name");
  return word;
}

PlyElement parse_element(TextCursor& cursor) {
  PlyElement element;
  element.name = parse_name(cursor);
  element.count_word = cursor.next_in_line();
  element.count = cursor.whole(element.count_word, "the number of elements");
  return element;
}

PlyProperty parse_property(TextCursor& cursor) {
  PlyProperty property;
  std::string_view word = cursor.next_in_line();
  if (word == "list") {
    const std::string_view count_word = cursor.next_in_line();
    property.count_type = parse_type(cursor, count_word);
    if (*property.count_type == PlyType::kFloat || *property.count_type == PlyType::kDouble) {
      cursor.fail(count_word, quoted(count_word) + " counts a list; expected a whole number type");
    }
    word = cursor.next_in_line();
  }
  property.type = parse_type(cursor, word);
  property.name = parse_name(cursor);
  return property;
}

/// The fewest bytes that one instance takes. Text: a digit and white space for each number.
std::size_t smallest_size(const PlyElement& element, PlyFormat format) {
  std::size_t bytes = 0;
  for (const PlyProperty& property : element.properties) {
    bytes += format == PlyFormat::kText ? 2 : size_of(property.count_type.value_or(property.type));
  }
  return bytes;
}

}  // namespace

std::size_t size_of(PlyType type) {
  constexpr std::array<std::size_t, 8> kSizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
  for (std::size_t i = 0; i < properties.size(); ++i) {
    if (properties[i].name == property) return i;
  }
  return std::nullopt;
}

std::optional<std::size_t> fixed_size_of(const PlyElement& element) {
  std::size_t bytes = 0;
  for (const PlyProperty& property : element.properties) {
    if (property.count_type) return std::nullopt;
    bytes += size_of(property.type);
  }
  return bytes;
}

PlyHeader parse_ply_header(TextCursor& cursor, std::size_t total_bytes) {
  PlyHeader header;
  const std::string_view magic = cursor.next_in_line();
  if (magic != "ply") cursor.fail(magic, found(magic) + "; expected ply");
  cursor.next_line();
  header.format = parse_format(cursor);
  for (;;) {
    if (const std::string_view rest = cursor.next_in_line(); !rest.empty()) {
      cursor.fail(rest, quoted(rest) + " stands here; expected the end of the line");
    }
    cursor.next_line();
    const std::string_view keyword = cursor.next_in_line();
    if (keyword == "end_header") break;
    if (keyword == "element") {
      header.elements.push_back(parse_element(cursor));
    } else if (keyword == "property") {
      if (header.elements.empty()) cursor.fail(keyword, "a property of nothing; expected an element first");
      header.elements.back().properties.push_back(parse_property(cursor));
    } else if (keyword == "comment" || keyword == "obj_info") {
      while (!cursor.next_in_line().empty()) {
      }
    } else if (!keyword.empty() || cursor.bytes_left() == 0) {
      cursor.fail(keyword, (keyword.empty() ? "the file ends" : quoted(keyword) + " stands here") +
                               std::string("; expected element, property, comment or end_header"));
    }
  }
  cursor.next_line();
  header.body = cursor.position();
  std::size_t left = total_bytes - header.body + 1;  // the last number may end the file
  for (const PlyElement& element : header.elements) {
    const std::uint64_t needed = std::uint64_t{element.count} * smallest_size(element, header.format);
    if (needed > left) {
      cursor.fail(element.count_word, std::string(element.count_word) + " elements do not fit in the " +
                                          std::to_string(total_bytes - header.body) +
                                          " bytes that follow; expected a number that the file holds");
    }
    left -= needed;
  }
  return header;
}

}  // namespace plumb

#include "meshes/formats/ply_numbers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <utility>

#include "renderer/math/input_error.h"

namespace plumb {
namespace {

static_assert(std::endian::native == std::endian::little, "the numbers below are copied in the machine's byte order");

template <class Number>
double as(const std::array<char, 8>& raw) {
  Number number;
  std::memcpy(&number, raw.data(), sizeof number);
  return number;
}

}  // namespace

PlyNumbers::PlyNumbers(std::string_view content, std::string file, const TextCursor& at_body, PlyFormat format)
    : content_(content), file_(std::move(file)), text_(at_body), format_(format), offset_(at_body.position()) {}

double PlyNumbers::take(PlyType type) {
  if (format_ == PlyFormat::kText) {
    word_ = text_.next();
    if (word_.empty()) fail("the file ends; expected as many numbers as its header says");
    return text_.number(word_, "a number");
  }
  const std::size_t size = size_of(type);
  if (content_.size() - offset_ < size) fail("the file ends; expected as many numbers as its header says");
  std::array<char, 8> raw{};
  std::memcpy(raw.data(), content_.data() + offset_, size);
  if (format_ == PlyFormat::kBigEndian) std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(size));
  offset_ += size;
  switch (type) {
    case PlyType::kInt8:
      return as<std::int8_t>(raw);
    case PlyType::kUint8:
      return as<std::uint8_t>(raw);
    case PlyType::kInt16:
      return as<std::int16_t>(raw);
    case PlyType::kUint16:
      return as<std::uint16_t>(raw);
    case PlyType::kInt32:
      return as<std::int32_t>(raw);
    case PlyType::kUint32:
      return as<std::uint32_t>(raw);
    case PlyType::kFloat:
      return as<float>(raw);
    case PlyType::kDouble:
      break;
  }
  return as<double>(raw);
}

bool PlyNumbers::is_rounded_to(float value) const {
  return format_ == PlyFormat::kText ? is_rounded(word_, value) : double{value} != last_;
}

void PlyNumbers::expect_end() {
  if (format_ != PlyFormat::kText) {
    if (offset_ == content_.size()) return;
    fail(std::to_string(content_.size() - offset_) + " bytes follow the last element; expected the end of the file");
  }
  word_ = text_.next();
  if (!word_.empty()) fail(quoted(word_) + " follows the last element; expected the end of the file");
}

void PlyNumbers::fail(const std::string& what) const {
  if (format_ == PlyFormat::kText) text_.fail(word_, what);
  throw InputError({file_}, what);
}

}  // namespace plumb

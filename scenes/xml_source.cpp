#include "scenes/xml_source.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <pugixml.hpp>

#include "renderer/math/input_error.h"

namespace plumb {
namespace {

constexpr std::uintmax_t kLargestFile = 256U << 20;

std::string read_text(const std::filesystem::path& file) {
  const SourceLocation where{file.string()};
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) throw InputError(where, "this is a folder, expected a scene file");
  if (std::filesystem::exists(file, error) && !std::filesystem::is_regular_file(file, error))
    throw InputError(where, "this is no ordinary file, expected a scene file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(where, std::string("cannot open the scene: ") + std::strerror(errno));
  std::string text;
  std::vector<char> chunk(1 << 16);
  while (stream.read(chunk.data(), static_cast<std::streamsize>(chunk.size())) || stream.gcount() > 0) {
    text.append(chunk.data(), static_cast<std::size_t>(stream.gcount()));
    if (std::memchr(chunk.data(), 0, static_cast<std::size_t>(stream.gcount())))
      throw InputError(where, "the scene holds a zero byte, expected text");
    if (text.size() > kLargestFile) throw InputError(where, "the scene is larger than 256 MiB");
  }
  return text;
}

/// pugixml's sentences, without their lead-in.
std::string reason(const pugi::xml_parse_result& result) {
  std::string text = result.description();
  if (!text.empty()) text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return "malformed XML: " + text + ", expected a well-formed scene file";
}

}  // namespace

XmlSource::XmlSource(const std::filesystem::path& file)
    : file_(std::make_shared<const std::string>(file.string())),
      text_(read_text(file)),
      document_(std::make_unique<pugi::xml_document>()) {
  line_starts_.push_back(0);
  for (std::size_t at = text_.find('\n'); at != std::string::npos; at = text_.find('\n', at + 1))
    line_starts_.push_back(at + 1);

  const auto result = document_->load_buffer(text_.data(), text_.size(),
                                             pugi::parse_default | pugi::parse_doctype | pugi::parse_ws_pcdata);
  if (!result) fail(result.offset, reason(result));

  int roots = 0;
  for (const pugi::xml_node& node : document_->children()) {
    if (node.type() == pugi::node_doctype)
      fail(offset(node), "a document type (<!DOCTYPE>) is not accepted in a scene");
    if (node.type() == pugi::node_element && ++roots > 1)
      fail(offset(node), "a second root element, expected one <scene>");
  }
  if (roots == 0) fail(0, "no element at all, expected <scene>");
}

XmlSource::~XmlSource() = default;

pugi::xml_node XmlSource::root() const { return document_->document_element(); }

TextPosition XmlSource::position(const pugi::xml_node& node) const { return position(offset(node)); }

std::ptrdiff_t XmlSource::offset(const pugi::xml_node& node) const {
  const std::size_t at =
      std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0)), text_.size());
  if (node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata) {
    return static_cast<std::ptrdiff_t>(std::min(text_.find_first_not_of(" \t\r\n\f\v", at), text_.size()));
  }
  // What pugixml gives is the place of the name after the '<'.
  const std::size_t open = text_.rfind('<', at);
  return static_cast<std::ptrdiff_t>(open == std::string::npos ? at : open);
}

TextPosition XmlSource::position(std::ptrdiff_t offset) const {
  const std::size_t at = std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)), text_.size());
  const auto next = std::upper_bound(line_starts_.begin(), line_starts_.end(), at);
  return {static_cast<int>(next - line_starts_.begin()), static_cast<int>(at - *(next - 1)) + 1};
}

void XmlSource::fail(std::ptrdiff_t offset, const std::string& what) const {
  const TextPosition where = position(offset);
  throw InputError({*file_, where.line, where.column}, what);
}

}  // namespace plumb

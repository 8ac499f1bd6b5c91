#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "scenes/object_description.h"

namespace pugi {
class xml_document;
class xml_node;
}  // namespace pugi

namespace plumb {

/// An XML file in memory, its tree, and the line and column of each of its nodes.
class XmlSource {
 public:
  /// Throws InputError if the file cannot be read, is larger than 256 MiB, is not well-formed XML, or holds
  /// a document type or entities (they are refused, so that no small file grows without bound).
  explicit XmlSource(const std::filesystem::path& file);
  ~XmlSource();

  /// The root element; there is exactly one.
  pugi::xml_node root() const;
  /// Where the node's tag, or the first letter of its text, begins.
  TextPosition position(const pugi::xml_node& node) const;
  const std::shared_ptr<const std::string>& file() const { return file_; }

 private:
  TextPosition position(std::ptrdiff_t offset) const;
  std::ptrdiff_t offset(const pugi::xml_node& node) const;
  [[noreturn]] void fail(std::ptrdiff_t offset, const std::string& what) const;

  std::shared_ptr<const std::string> file_;
  std::string text_;
  std::vector<std::size_t> line_starts_;
  std::unique_ptr<pugi::xml_document> document_;
};

}  // namespace plumb

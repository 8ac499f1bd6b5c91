#include "renderer/math/input_error.h"

#include <utility>

namespace plumb {

std::string to_string(const SourceLocation& where) {
  std::string text = where.file;
  if (where.line > 0) text += ":" + std::to_string(where.line);
  if (where.line > 0 && where.column > 0) text += ":" + std::to_string(where.column);
  return text;
}

namespace {
/// Names and values from files may hold line breaks and terminal codes; the message stays one harmless line.
std::string one_line(const std::string& text) {
  std::string line;
  for (const char c : text) line += (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) ? '?' : c;
  return line;
}
}  // namespace

InputError::InputError(SourceLocation where, const std::string& what)
    : std::runtime_error(one_line(where.file.empty() ? what : to_string(where) + ": " + what)),
      where_(std::move(where)) {}

}  // namespace plumb

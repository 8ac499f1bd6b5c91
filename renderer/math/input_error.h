#pragma once

#include <stdexcept>
#include <string>

namespace plumb {

/// A place in a file. Line and column count from 1 (columns in bytes); 0 says that it is not known.
struct SourceLocation {
  std::string file;
  int line = 0;
  int column = 0;
};

/// `file:line:column`, without the parts that are not known.
std::string to_string(const SourceLocation& where);

/// The one exception for input that cannot be used: scenes, meshes, pictures, suites, options. Its
/// text is one line, `file:line:column: what, and what was expected`. Programs turn it into exit status 2.
class InputError : public std::runtime_error {
 public:
  InputError(SourceLocation where, const std::string& what);
  const SourceLocation& where() const { return where_; }

 private:
  SourceLocation where_;
};

}  // namespace plumb

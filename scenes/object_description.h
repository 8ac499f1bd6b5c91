#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/math/input_error.h"
#include "renderer/math/vec3.h"
#include "scenes/kind.h"
#include "scenes/value.h"

namespace plumb {

/// A line and column of the scene's file, both from 1.
struct TextPosition {
  int line = 0;
  int column = 0;
};

/// One value or object given inside an element. An alias is stored under the parameter it names.
struct Property {
  const Parameter* parameter;
  Value value;
  TextPosition where;
};

/// An element of a scene with the values it was given, in file order: parsed, not yet built.
///
/// The getters take a parameter of the kind's table and return the last value given, or the table's default;
/// a name or type that is not in the table is a std::logic_error.
struct ObjectDescription {
  const Kind* kind = nullptr;
  std::string name;
  std::shared_ptr<const std::string> file;
  TextPosition position;
  std::vector<Property> properties;

  double number(std::string_view parameter) const;
  int integer(std::string_view parameter) const;
  Vec3 vector(std::string_view parameter) const;
  Point3 point(std::string_view parameter) const;
  Color color(std::string_view parameter) const;
  Size2 size(std::string_view parameter) const;
  std::string file_name(std::string_view parameter) const;
  /// Null if an optional object is not given.
  ObjectPointer object(std::string_view parameter) const;
  /// In file order.
  std::vector<ObjectPointer> objects(std::string_view parameter) const;
  bool has(std::string_view parameter) const;

  /// Where the element begins, and where a value of it was given (the element's own place if it was not).
  SourceLocation where() const;
  SourceLocation where(std::string_view parameter) const;
};

}  // namespace plumb

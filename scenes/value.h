#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "renderer/math/input_error.h"
#include "renderer/math/vec3.h"
#include "scenes/kind.h"

namespace plumb {

struct ObjectDescription;

/// An object that is given once and referred to from several places is shared: the same pointer.
using ObjectPointer = std::shared_ptr<const ObjectDescription>;

struct Size2 {
  int width = 0;
  int height = 0;
  friend bool operator==(const Size2&, const Size2&) = default;
};

/// number: double; integer: int; size: Size2; point, vector, color: Vec3; file: string; object: pointer.
using Value = std::variant<double, int, Size2, Vec3, std::string, ObjectPointer>;

/// Reads the text of a parameter that is not an object: exactly the count of numbers it takes, separated
/// by any white space, finite, within its range. Throws InputError at `where`.
Value parse_value(const Parameter& parameter, std::string_view text, const SourceLocation& where);

/// Throws InputError at `where` if a number of the value lies outside of the parameter's range. Values that are not
/// numbers pass.
void check_range(const Parameter& parameter, const Value& value, const SourceLocation& where);

}  // namespace plumb

#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// What an element of a scene is, whatever its tag: a `substrate` has the role of a shader.
enum class Role { scene, camera, light, shader, surface };

/// How the text of an element is read.
enum class ValueType {
  number,   ///< one number
  integer,  ///< one whole number
  size,     ///< two whole numbers: width and height
  point,    ///< three numbers
  vector,   ///< three numbers
  color,    ///< three numbers, linear red, green, blue
  file,     ///< a file name, relative to the scene's folder
  object,   ///< elements of its own; Parameter::role says of which role
};

/// Which values of a number (of every component) are meant.
enum class Range { any, not_negative, positive };

/// Whether an element must be given. An optional one has no default; its meaning says what happens without it.
enum class Presence { required, optional, defaulted };

/// One row of a kind's parameter table: the one truth for the reader, its error messages and the manual.
struct Parameter {
  std::string_view name;
  ValueType type;
  std::string_view meaning;
  Presence presence = Presence::required;
  /// For Presence::defaulted, in the words of a scene file.
  std::string_view default_text = "";
  std::string_view unit = "";
  Range range = Range::any;
  /// The largest value that is accepted.
  double largest = std::numeric_limits<double>::infinity();
  /// For ValueType::object.
  Role role = Role::scene;
  /// May be given any number of times, each counting; otherwise the last one wins.
  bool repeatable = false;
  /// Another name for the parameter of this name.
  std::string_view alias_of = "";
  /// The dialect that brought it, or "plumbline" for what the course's own programs do not know.
  std::string_view since = "pa3-2011";
};

/// A class of element: what `type` names. Each has one constant, in the file of the class it describes.
struct Kind {
  Role role;
  std::string_view name;
  std::string_view meaning;
  std::span<const Parameter> parameters;
};

/// The kinds a reader knows. The kind that a role takes where `type` is not written is the first of that role
/// among those in `untyped`.
struct KindTable {
  std::vector<const Kind*> kinds;
  std::vector<const Kind*> untyped;

  const Kind* find(Role role, std::string_view name) const;
  const Kind* default_of(Role role) const;
  std::vector<std::string_view> names(Role role) const;
};

std::string_view to_string(Role role);
/// For messages: "three numbers", "one whole number".
std::string_view to_string(ValueType type);

}  // namespace plumb

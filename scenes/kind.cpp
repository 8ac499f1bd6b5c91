#include "scenes/kind.h"

#include <stdexcept>

namespace plumb {

const Kind* KindTable::find(Role role, std::string_view name) const {
  for (const Kind* kind : kinds)
    if (kind->role == role && kind->name == name) return kind;
  return nullptr;
}

const Kind* KindTable::default_of(Role role) const {
  for (const Kind* kind : untyped)
    if (kind->role == role) return kind;
  return nullptr;
}

std::vector<std::string_view> KindTable::names(Role role) const {
  std::vector<std::string_view> names;
  for (const Kind* kind : kinds)
    if (kind->role == role) names.push_back(kind->name);
  return names;
}

std::string_view to_string(Role role) {
  switch (role) {
    case Role::scene:
      return "scene";
    case Role::camera:
      return "camera";
    case Role::light:
      return "light";
    case Role::shader:
      return "shader";
    case Role::surface:
      return "surface";
  }
  throw std::logic_error("unknown role");
}

std::string_view to_string(ValueType type) {
  switch (type) {
    case ValueType::number:
      return "one number";
    case ValueType::integer:
      return "one whole number";
    case ValueType::size:
      return "two whole numbers (width height)";
    case ValueType::point:
      return "three numbers (x y z)";
    case ValueType::vector:
      return "three numbers (x y z)";
    case ValueType::color:
      return "three numbers (red green blue)";
    case ValueType::file:
      return "a file name";
    case ValueType::object:
      return "elements";
  }
  throw std::logic_error("unknown value type");
}

}  // namespace plumb

#include "scenes/object_description.h"

#include <stdexcept>

namespace plumb {
namespace {

const Parameter& parameter_of(const Kind& kind, std::string_view name) {
  for (const Parameter& parameter : kind.parameters)
    if (parameter.name == name) return parameter;
  throw std::logic_error("kind " + std::string(kind.name) + " has no parameter " + std::string(name));
}

const Property* last_given(const ObjectDescription& object, std::string_view name) {
  const Parameter& parameter = parameter_of(*object.kind, name);
  for (auto it = object.properties.rbegin(); it != object.properties.rend(); ++it)
    if (it->parameter == &parameter) return &*it;
  return nullptr;
}

Value value_of(const ObjectDescription& object, std::string_view name) {
  if (const Property* property = last_given(object, name)) return property->value;
  const Parameter& parameter = parameter_of(*object.kind, name);
  if (parameter.presence != Presence::defaulted) {
    throw std::logic_error("parameter " + std::string(name) + " has neither value nor default");
  }
  return parse_value(parameter, parameter.default_text, {});
}

}  // namespace

double ObjectDescription::number(std::string_view parameter) const {
  return std::get<double>(value_of(*this, parameter));
}
int ObjectDescription::integer(std::string_view parameter) const { return std::get<int>(value_of(*this, parameter)); }
Vec3 ObjectDescription::vector(std::string_view parameter) const { return std::get<Vec3>(value_of(*this, parameter)); }

Point3 ObjectDescription::point(std::string_view parameter) const {
  const Vec3 v = vector(parameter);
  return {v.x, v.y, v.z};
}

Color ObjectDescription::color(std::string_view parameter) const {
  const Vec3 v = vector(parameter);
  return {v.x, v.y, v.z};
}

Size2 ObjectDescription::size(std::string_view parameter) const { return std::get<Size2>(value_of(*this, parameter)); }

std::string ObjectDescription::file_name(std::string_view parameter) const {
  return std::get<std::string>(value_of(*this, parameter));
}

ObjectPointer ObjectDescription::object(std::string_view parameter) const {
  const Property* property = last_given(*this, parameter);
  return property ? std::get<ObjectPointer>(property->value) : nullptr;
}

std::vector<ObjectPointer> ObjectDescription::objects(std::string_view parameter) const {
  const Parameter& wanted = parameter_of(*kind, parameter);
  std::vector<ObjectPointer> found;
  for (const Property& property : properties)
    if (property.parameter == &wanted) found.push_back(std::get<ObjectPointer>(property.value));
  return found;
}

bool ObjectDescription::has(std::string_view parameter) const { return last_given(*this, parameter) != nullptr; }

SourceLocation ObjectDescription::where() const { return {file ? *file : "", position.line, position.column}; }

SourceLocation ObjectDescription::where(std::string_view parameter) const {
  const Property* property = last_given(*this, parameter);
  if (!property) return where();
  return {file ? *file : "", property->where.line, property->where.column};
}

}  // namespace plumb

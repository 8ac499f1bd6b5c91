// Prints docs/scene-format.md from the parameter tables, which are the reader's own: the manual cannot fall behind.

#include <fmt/format.h>

#include <string>

#include "renderer/kinds.h"
#include "scenes/scene_kind.h"

namespace plumb {
namespace {

constexpr std::string_view kIntroduction = R"(# The scene format

<!-- Written from the parameter tables: build/release/bin/write_scene_format > docs/scene-format.md -->

A scene is an XML file with one `<scene>` element, the format of Cornell's CS 4620 ray tracing assignments. Dialect: `pa3-2011`.

- Tags match regardless of case. A tag that is not in these tables is an error, with the nearest known name.
- `type="..."` names a kind, with or without a package before it: `type="ray.shader.Phong"` is `Phong`. Cameras and lights have one kind,
  so theirs need not be written.
- `name="x"` names an element, any element; `ref="x"` on a later one stands for it and shares it. A surface that several groups refer to
  is stored once.
- Numbers are separated by any white space. NaN and infinity are errors, and so is a wrong count of numbers.
- A tag that is not marked *repeatable* and is given twice: the last one counts, with a warning.
- Document types and entities are refused.
- Mesh files are named relative to the scene's folder. Their numbers are rounded to single precision, as the course's framework stores them.
- The picture of `X.xml` is `X.xml.png`. Its levels are c^(1/2.2) of the linear mean of the samples, clamped to [0,1], rounded to float,
  then floor(255 c + 0.5).
- `Box`: with a `minPt` beyond its `maxPt` it has no inside. The course's renderer draws such a box through its slab loop, and so does
  this one, with a warning; no check uses one.
- `Cone`: both nappes count. A tip within the kept height makes a double cone.

Columns: *default* is what counts if the tag is missing (**required**: it must be there); *since* says which dialect brought the tag, where
`plumbline` marks those that the course's own programs do not know.
)";

std::string_view type_name(const Parameter& p) {
  switch (p.type) {
    case ValueType::number:
      return "number";
    case ValueType::integer:
      return "whole number";
    case ValueType::size:
      return "width height";
    case ValueType::point:
      return "point";
    case ValueType::vector:
      return "vector";
    case ValueType::color:
      return "color";
    case ValueType::file:
      return "file name";
    case ValueType::object:
      return to_string(p.role);
  }
  return "";
}

std::string default_text(const Parameter& p) {
  switch (p.presence) {
    case Presence::required:
      return "**required**";
    case Presence::optional:
      return "-";
    case Presence::defaulted:
      return fmt::format("`{}`", p.default_text);
  }
  return "";
}

std::string meaning(const Parameter& p) {
  std::string text(p.meaning);
  if (p.range == Range::not_negative) text += "; not negative";
  if (p.range == Range::positive) text += "; greater than zero";
  if (p.repeatable) text += " *(repeatable)*";
  return text;
}

void print_kind(const Kind& kind, std::string_view heading) {
  fmt::print("\n### {}\n\n{}\n\n", heading, kind.meaning);
  fmt::print("| tag | type | unit | default | meaning | since |\n| --- | --- | --- | --- | --- | --- |\n");
  for (const Parameter& p : kind.parameters)
    fmt::print("| `{}` | {} | {} | {} | {} | {} |\n", p.name, type_name(p), p.unit, default_text(p), meaning(p),
               p.since);
}

}  // namespace
}  // namespace plumb

int main() {
  using namespace plumb;
  fmt::print("{}", kIntroduction);
  fmt::print("\n## The scene\n");
  print_kind(scene_kind, "`<scene>`");
  const KindTable kinds = renderer_kinds(Dialect::pa3_2011);
  for (const Role role : {Role::camera, Role::light, Role::shader, Role::surface}) {
    std::string title(to_string(role));
    title[0] = static_cast<char>(title[0] - 'a' + 'A');
    fmt::print("\n## {}s\n", title);
    for (const Kind* kind : kinds.kinds)
      if (kind->role == role) print_kind(*kind, fmt::format("`<{} type=\"{}\">`", to_string(role), kind->name));
    if (role == Role::surface) print_kind(group_kind, "`<surface type=\"Group\">`");
  }
  return 0;
}

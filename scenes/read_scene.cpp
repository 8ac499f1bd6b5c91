#include "scenes/read_scene.h"

#include <algorithm>
#include <initializer_list>
#include <map>
#include <pugixml.hpp>
#include <span>
#include <utility>

#include "renderer/math/nearest_name.h"
#include "scenes/scene_kind.h"
#include "scenes/xml_source.h"

namespace plumb {
namespace {

constexpr int kDeepestNesting = 1000;

std::string in_quotes(std::string_view word) { return "'" + std::string(word) + "'"; }
std::string tag(std::string_view name) { return "<" + std::string(name) + ">"; }

bool is_blank(std::string_view text) { return text.find_first_not_of(" \t\r\n\f\v") == std::string_view::npos; }

/// `ray.shader.Lambertian` names the same class as `Lambertian`.
std::string_view without_package(std::string_view type) {
  const std::size_t dot = type.rfind('.');
  return dot == std::string_view::npos ? type : type.substr(dot + 1);
}

class SceneReader {
 public:
  SceneReader(const XmlSource& source, const KindTable& kinds) : source_(source), kinds_(kinds) {
    kinds_.kinds.push_back(&group_kind);
  }

  SceneDescription read() {
    const pugi::xml_node root = source_.root();
    if (!equal_ignoring_case(root.name(), "scene"))
      fail(root, "the root element is " + tag(root.name()) + ", expected <scene>");
    check_attributes(root, {"name"});
    description_.scene = read_object(root, scene_kind, 0);
    check_image_size(*description_.scene);
    return std::move(description_);
  }

 private:
  /// What a `name` stands for: only a parameter that takes the same kind of thing may refer to it.
  struct Named {
    ValueType type;
    Role role;
    Value value;
  };

  [[noreturn]] void fail(const pugi::xml_node& node, const std::string& what) const {
    throw InputError(location(node), what);
  }

  SourceLocation location(const pugi::xml_node& node) const {
    const TextPosition at = source_.position(node);
    return {*source_.file(), at.line, at.column};
  }

  void warn(const pugi::xml_node& node, const std::string& what) {
    description_.warnings.push_back(to_string(location(node)) + ": warning: " + what);
  }

  ObjectPointer read_object(const pugi::xml_node& node, const Kind& kind, int depth) {
    if (depth > kDeepestNesting) fail_nesting(node);
    auto object = std::make_shared<ObjectDescription>();
    object->kind = &kind;
    object->name = node.attribute("name").value();
    object->file = source_.file();
    object->position = source_.position(node);
    for (const pugi::xml_node& child : node.children()) {
      if (child.type() == pugi::node_element) {
        read_property(child, kind, *object, depth);
      } else if (!is_blank(child.value())) {
        fail_text(child, node);
      }
    }
    check_complete(node, *object);
    return object;
  }

  // Elements nest, and so do the calls that read them. What makes messages stays out of those calls' frames, so that
  // the deepest nesting fits a stack of 8 MiB under the address sanitizer too.

  [[noreturn, gnu::noinline]] void fail_nesting(const pugi::xml_node& node) const {
    fail(node, "elements are nested more than " + std::to_string(kDeepestNesting) + " deep");
  }

  [[noreturn, gnu::noinline]] void fail_text(const pugi::xml_node& text, const pugi::xml_node& node) const {
    fail(text, "unexpected text in " + tag(node.name()) + ", expected elements");
  }

  [[gnu::noinline]] void check_complete(const pugi::xml_node& node, const ObjectDescription& object) const {
    for (const Parameter& parameter : object.kind->parameters) {
      if (parameter.presence == Presence::required && !object.has(parameter.name)) {
        fail(node, tag(node.name()) + " of kind " + std::string(object.kind->name) + " lacks " + tag(parameter.name) +
                       ", expected " + std::string(to_string(parameter.type)));
      }
    }
  }

  [[gnu::noinline]] void warn_of_repetition(const pugi::xml_node& node, int line) {
    warn(node, tag(node.name()) + " was given before at line " + std::to_string(line) + "; the last one counts");
  }

  [[gnu::noinline]] void remember_name(const pugi::xml_node& node, const Parameter& parameter, const Value& value) {
    const std::string name = node.attribute("name").value();
    if (name.empty()) return;
    if (named_.contains(name))
      warn(node, "the name " + in_quotes(name) + " was given before; from here on it means this element");
    named_.insert_or_assign(name, Named{parameter.type, parameter.role, value});
  }

  void read_property(const pugi::xml_node& node, const Kind& owner, ObjectDescription& object, int depth) {
    const Parameter& written = parameter_for(node, owner);
    const Parameter& parameter = written.alias_of.empty() ? written : parameter_named(owner, written.alias_of);
    if (parameter.type == ValueType::object)
      check_attributes(node, {"type", "name", "ref"});
    else
      check_attributes(node, {"name", "ref"});
    if (!parameter.repeatable && object.has(parameter.name))
      warn_of_repetition(node, object.where(parameter.name).line);
    Value value = node.attribute("ref") ? referred(node, parameter) : read_value(node, parameter, depth);
    remember_name(node, parameter, value);
    object.properties.push_back({&parameter, std::move(value), source_.position(node)});
  }

  Value read_value(const pugi::xml_node& node, const Parameter& parameter, int depth) {
    if (parameter.type != ValueType::object) return read_text_value(node, parameter);
    return read_object(node, kind_for(node, parameter.role), depth + 1);
  }

  [[gnu::noinline]] Value read_text_value(const pugi::xml_node& node, const Parameter& parameter) const {
    std::string text;
    for (const pugi::xml_node& child : node.children()) {
      if (child.type() == pugi::node_element) {
        fail(child, "unexpected " + tag(child.name()) + " in " + tag(node.name()) + ", expected " +
                        std::string(to_string(parameter.type)));
      }
      text += child.value();
    }
    return parse_value(parameter, text, location(node));
  }

  [[gnu::noinline]] const Parameter& parameter_for(const pugi::xml_node& node, const Kind& owner) const {
    std::vector<std::string_view> names;
    for (const Parameter& parameter : owner.parameters) {
      if (equal_ignoring_case(parameter.name, node.name())) return parameter;
      names.push_back(parameter.name);
    }
    std::string known;
    for (const std::string_view name : names) known += (known.empty() ? "" : ", ") + std::string(name);
    if (known.empty()) known = "no elements";
    fail(node, "unknown tag " + tag(node.name()) + " in " + std::string(owner.name) + ", expected " + known +
                   did_you_mean(node.name(), names));
  }

  static const Parameter& parameter_named(const Kind& owner, std::string_view name) {
    for (const Parameter& parameter : owner.parameters)
      if (parameter.name == name) return parameter;
    throw std::logic_error("an alias names a parameter that does not exist");
  }

  void check_attributes(const pugi::xml_node& node, std::span<const std::string_view> known) const {
    std::string expected;
    for (const std::string_view name : known) expected += (expected.empty() ? "" : ", ") + std::string(name);
    for (const pugi::xml_attribute& attribute : node.attributes()) {
      const std::string_view name = attribute.name();
      if (std::ranges::find(known, name) == known.end()) {
        fail(node, "unknown attribute " + in_quotes(name) + " of " + tag(node.name()) + ", expected " + expected +
                       did_you_mean(name, known));
      }
      if (node.attribute(attribute.name()) != attribute)
        fail(node, "the attribute " + in_quotes(name) + " of " + tag(node.name()) + " is given twice, expected once");
    }
  }

  [[gnu::noinline]] void check_attributes(const pugi::xml_node& node,
                                          std::initializer_list<std::string_view> known) const {
    check_attributes(node, std::span<const std::string_view>(known.begin(), known.size()));
  }

  [[gnu::noinline]] const Kind& kind_for(const pugi::xml_node& node, Role role) const {
    const pugi::xml_attribute type = node.attribute("type");
    if (!type) {
      if (const Kind* kind = kinds_.default_of(role)) return *kind;
      fail(node, tag(node.name()) + " has no type, expected type=\"...\" with one of " + known_kinds(role));
    }
    const std::string_view name = without_package(type.value());
    if (const Kind* kind = kinds_.find(role, name)) return *kind;
    fail(node, "unknown type " + in_quotes(type.value()) + " of " + tag(node.name()) + ", expected one of " +
                   known_kinds(role) + did_you_mean(name, kinds_.names(role)));
  }

  std::string known_kinds(Role role) const {
    std::string text;
    for (const std::string_view name : kinds_.names(role)) text += (text.empty() ? "" : ", ") + std::string(name);
    return text;
  }

  [[gnu::noinline]] Value referred(const pugi::xml_node& node, const Parameter& parameter) const {
    const std::string ref = node.attribute("ref").value();
    for (const pugi::xml_node& child : node.children()) {
      if (child.type() == pugi::node_element || !is_blank(child.value()))
        fail(child, tag(node.name()) + " has both a ref and content, expected one of them");
    }
    const auto found = named_.find(ref);
    if (found == named_.end()) fail_unknown_name(node, ref);
    const Named& target = found->second;
    if (target.type != parameter.type || (target.type == ValueType::object && target.role != parameter.role)) {
      fail(node, in_quotes(ref) + " names " + described(target) + ", expected " +
                     (parameter.type == ValueType::object ? "a " + std::string(to_string(parameter.role))
                                                          : std::string(to_string(parameter.type))));
    }
    if (const pugi::xml_attribute type = node.attribute("type");
        type && without_package(type.value()) != std::get<ObjectPointer>(target.value)->kind->name) {
      fail(node, in_quotes(ref) + " names a " + std::string(std::get<ObjectPointer>(target.value)->kind->name) +
                     ", expected the type " + in_quotes(type.value()));
    }
    check_range(parameter, target.value, location(node));
    return target.value;
  }

  [[noreturn]] void fail_unknown_name(const pugi::xml_node& node, const std::string& ref) const {
    const pugi::xml_node later =
        source_.root().find_node([&](const pugi::xml_node& n) { return ref == n.attribute("name").value(); });
    if (!ref.empty() && later) {
      fail(node, "the name " + in_quotes(ref) + " is not complete before line " +
                     std::to_string(source_.position(later).line) +
                     ", expected the element that is named to end before the one that refers to it");
    }
    std::vector<std::string_view> names;
    source_.root().find_node([&](const pugi::xml_node& n) {
      if (const pugi::xml_attribute name = n.attribute("name")) names.push_back(name.value());
      return false;
    });
    fail(node,
         "nothing is named " + in_quotes(ref) + ", expected the name of an earlier element" + did_you_mean(ref, names));
  }

  static std::string described(const Named& target) {
    return target.type == ValueType::object ? "a " + std::string(to_string(target.role))
                                            : std::string(to_string(target.type));
  }

  void check_image_size(const ObjectDescription& scene) const {
    const Size2 size = scene.size("image");
    if (size.width > kLargestImageSide || size.height > kLargestImageSide ||
        static_cast<long>(size.width) * size.height > kMostImagePixels) {
      throw InputError(scene.where("image"), "a picture of " + std::to_string(size.width) + "x" +
                                                 std::to_string(size.height) + " is too large, expected at most " +
                                                 std::to_string(kLargestImageSide) + " a side and " +
                                                 std::to_string(kMostImagePixels) + " pixels");
    }
  }

  const XmlSource& source_;
  KindTable kinds_;
  SceneDescription description_;
  std::map<std::string, Named, std::less<>> named_;
};

}  // namespace

SceneDescription read_scene(const std::filesystem::path& file, const KindTable& kinds) {
  const XmlSource source(file);
  SceneDescription description = SceneReader(source, kinds).read();
  description.file = file;
  return description;
}

}  // namespace plumb

#include "scenes/moved_camera.h"

#include <strings.h>

#include <array>
#include <cstdio>
#include <pugixml.hpp>
#include <sstream>
#include <string_view>
#include <utility>

#include "renderer/math/input_error.h"

namespace plumb {
namespace {

bool named(const pugi::xml_node& node, const char* name) { return ::strcasecmp(node.name(), name) == 0; }

template <class Triple>
std::string triple_text(const Triple& v) {
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(), "%.17g %.17g %.17g", v.x, v.y, v.z);
  return text.data();
}

void set_value(pugi::xml_node camera, const char* name, const std::string& text) {
  for (pugi::xml_node child = camera.first_child(); child;) {
    const pugi::xml_node next = child.next_sibling();
    if (named(child, name)) camera.remove_child(child);
    child = next;
  }
  camera.append_child(name).text().set(text.c_str());
}

}  // namespace

std::string scene_with_camera(const std::filesystem::path& scene, const CameraPlace& place) {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed =
      document.load_file(scene.c_str(), pugi::parse_default | pugi::parse_comments | pugi::parse_declaration);
  if (!parsed) throw InputError({scene.string()}, std::string("is no XML: ") + parsed.description());
  pugi::xml_node camera;
  int cameras = 0;
  for (const pugi::xml_node child : document.document_element())
    if (named(child, "camera")) camera = child, ++cameras;
  if (cameras > 1 || camera.attribute("ref"))
    throw InputError({scene.string()}, "has no <camera> of its own to be moved, expected at most one, without 'ref'");
  if (cameras == 0) camera = document.document_element().prepend_child("camera");
  set_value(camera, "viewPoint", triple_text(place.view_point));
  set_value(camera, "viewDir", triple_text(place.view_dir));
  set_value(camera, "viewUp", triple_text(place.view_up));
  if (place.proj_normal) set_value(camera, "projNormal", triple_text(*place.proj_normal));
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace plumb

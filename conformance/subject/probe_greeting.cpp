#include "conformance/subject/probe_greeting.h"

#include <fmt/format.h>

#include <span>
#include <string_view>
#include <utility>

#include "conformance/subject/probe_numbers.h"

namespace plumb {
namespace {

using nlohmann::json;

template <class Value>
using Choice = std::pair<std::string_view, Value>;

constexpr Choice<plumb_precision> kPrecisions[]{{"double", PLUMB_DOUBLE}, {"float", PLUMB_FLOAT}};
constexpr Choice<plumb_edge_rule> kEdges[]{{"closed", PLUMB_EDGE_CLOSED},
                                           {"top_left", PLUMB_EDGE_TOP_LEFT},
                                           {"watertight", PLUMB_EDGE_WATERTIGHT},
                                           {"none", PLUMB_EDGE_NONE}};
constexpr Choice<plumb_culling> kCulling[]{{"none", PLUMB_CULL_NONE}, {"back", PLUMB_CULL_BACK}};
constexpr Choice<plumb_range> kRanges[]{{"closed", PLUMB_RANGE_CLOSED}, {"open", PLUMB_RANGE_OPEN}};
constexpr Choice<plumb_inside> kInsides[]{{"exit", PLUMB_INSIDE_HITS_EXIT}, {"miss", PLUMB_INSIDE_MISSES}};
constexpr Choice<bool> kSurfaces[]{{"flat", false}, {"tree", true}};
constexpr Choice<unsigned> kShapes[]{{"mesh", PLUMB_MESHES},
                                     {"sphere", PLUMB_SPHERES},
                                     {"box", PLUMB_BOXES},
                                     {"cylinder", PLUMB_CYLINDERS},
                                     {"cone", PLUMB_CONES}};

/// The value of the word under the key; `otherwise` where the key is absent.
template <class Value, std::size_t n>
Value chosen(const json& greeting, const char* key, const Choice<Value> (&choices)[n], Value otherwise) {
  const auto found = greeting.find(key);
  if (found == greeting.end()) return otherwise;
  std::string known;
  for (const auto& [word, value] : choices) {
    if (*found == word) return value;
    known += fmt::format("{}\"{}\"", known.empty() ? "" : ", ", word);
  }
  protocol_fault(fmt::format("the greeting's \"{}\" is {}, expected one of {}", key, shown(*found), known));
}

/// Whether the list under the key holds the word; `otherwise` where the key is absent.
bool lists(const json& greeting, const char* key, std::string_view word, bool otherwise) {
  const auto found = greeting.find(key);
  if (found == greeting.end()) return otherwise;
  const std::string what = fmt::format("the greeting's \"{}\"", key);
  bool listed = false;
  for (const json& item : list_of(*found, what)) {
    if (!item.is_string()) protocol_fault(what + " holds something that is not text");
    listed = listed || item == word;
  }
  return listed;
}

std::string name_of(const json& greeting) {
  const auto found = greeting.find("name");
  if (found == greeting.end()) return "probe";
  std::string name = sentence_of(*found, "the greeting's \"name\"").substr(0, 60);
  for (char& c : name) {
    const bool plain =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.';
    if (!plain) c = '-';
  }
  return name.empty() ? "probe" : name;
}

}  // namespace

ProbeGreeting read_greeting(const json& greeting) {
  Contract c;
  c.precision = chosen(greeting, "precision", kPrecisions, PLUMB_DOUBLE);
  c.t_precision = chosen(greeting, "t_precision", kPrecisions, c.precision);
  c.edge_rule = chosen(greeting, "edges", kEdges, PLUMB_EDGE_CLOSED);
  c.culling = chosen(greeting, "culling", kCulling, PLUMB_CULL_NONE);
  c.range = chosen(greeting, "range", kRanges, PLUMB_RANGE_CLOSED);
  c.inside = chosen(greeting, "inside", kInsides, PLUMB_INSIDE_HITS_EXIT);
  chosen(greeting, "surfaces", kSurfaces, false);  // The list of surfaces itself says whether it has paths.

  const json& float_meshes = greeting.value("float_meshes", json(true));
  if (!float_meshes.is_boolean()) protocol_fault("the greeting's \"float_meshes\" is neither true nor false");
  c.float_meshes = float_meshes.get<bool>();

  c.shapes = 0;
  for (const auto& [word, bit] : kShapes)
    if (lists(greeting, "shapes", word, bit != PLUMB_CONES)) c.shapes |= bit;

  const auto can = [&](std::string_view word) { return lists(greeting, "can", word, false); };
  c.capabilities = PLUMB_TRANSFORMS;
  if (can("any")) c.capabilities |= PLUMB_ANY_HIT;
  if (can("all")) c.capabilities |= PLUMB_ALL_HITS;
  if (can("bounds")) c.capabilities |= PLUMB_BOUNDS;
  c.matrices = can("matrices");
  c.average_position = can("average_position");
  c.fresnel = can("fresnel");
  c.refract = can("refract");
  c.frame = can("frame");
  return {name_of(greeting), c, can("trace")};
}

}  // namespace plumb

#include "conformance/subject/probe_surfaces.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "conformance/subject/probe_numbers.h"
#include "conformance/subject/scene_file.h"

namespace plumb {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 6> kTypes{"Sphere", "Box", "Cylinder", "Cone", "Mesh", "Triangle"};

/// What a surface is known by.
struct Key {
  std::string path;
  std::string_view type;
  std::vector<double> numbers;
  bool operator==(const Key&) const = default;
  bool operator<(const Key& other) const {
    return std::tie(path, type, numbers) < std::tie(other.path, other.type, other.numbers);
  }
};

std::string to_string(const Key& key) {
  std::string text(key.type);
  for (const double number : key.numbers) text += fmt::format(" {}", number);
  return key.path.empty() ? text : text + " at " + key.path;
}

template <class Value>
using Keyed = std::pair<Key, Value>;

Key read_key(const json& listed) {
  const json& type = member(listed, "type", "a surface");
  const auto known = std::ranges::find_if(kTypes, [&](std::string_view name) { return type == name; });
  if (known == kTypes.end())
    protocol_fault(fmt::format("a surface's type is {}, expected one of {}", shown(type), fmt::join(kTypes, ", ")));
  Key key{"", *known, {}};
  if (const auto path = listed.find("path"); path != listed.end()) {
    if (!path->is_string() || path->get_ref<const std::string&>().empty())
      protocol_fault(fmt::format("a surface's path is {}, expected text as \"2/0/1\"", shown(*path)));
    key.path = path->get<std::string>();
  }
  const json& numbers = list_of(member(listed, "numbers", "a surface"), "a surface's list of numbers");
  key.numbers = finite_numbers(numbers, numbers.size(), "a surface's number");
  return key;
}

/// What the scene has, in the terms of a program's list.
class Expected {
 public:
  Expected(const SubjectScene& scene, const Contract& contract, bool paths)
      : scene_(scene), contract_(contract), paths_(paths) {}

  Keyed<ProbePlace> whole(std::uint32_t i) const {
    const Shape& s = scene_[i].shape;
    const bool as_float = contract_.precision == PLUMB_FLOAT;
    switch (s.kind) {
      case ShapeKind::sphere:
        return solid(i, "Sphere", {s.center.x, s.center.y, s.center.z, s.radius}, as_float);
      case ShapeKind::box:
        return solid(i, "Box", {s.min.x, s.min.y, s.min.z, s.max.x, s.max.y, s.max.z}, as_float);
      case ShapeKind::cylinder:
        return solid(i, "Cylinder", {s.center.x, s.center.y, s.center.z, s.radius, s.height}, as_float);
      case ShapeKind::cone:
        return solid(i, "Cone", {s.center.x, s.center.y, s.center.z, s.tip_z, s.radius, s.height}, as_float);
      case ShapeKind::triangle:
      case ShapeKind::mesh: {
        const auto count = static_cast<std::uint32_t>(file_mesh(s)->triangles.size());
        return {{path(i), "Mesh", {static_cast<double>(count)}}, {i, std::nullopt, count}};
      }
    }
    throw std::logic_error("unknown kind of a shape");
  }

  bool is_mesh(std::uint32_t i) const { return file_mesh(scene_[i].shape) != nullptr; }

  /// The triangles of a mesh, each by its vertices or by its number.
  void add_triangles(std::uint32_t i, bool by_vertices, std::vector<Keyed<ProbePlace>>& to) const {
    const auto mesh = file_mesh(scene_[i].shape);
    const bool as_float = contract_.precision == PLUMB_FLOAT || contract_.float_meshes;
    for (std::uint32_t t = 0; t < mesh->triangles.size(); ++t) {
      Key key{path(i), "Triangle", {}};
      if (!by_vertices) key.numbers = {static_cast<double>(t)};
      for (const std::uint32_t vertex : mesh->triangles[t]) {
        const Point3& p = mesh->positions[vertex];
        if (by_vertices) key.numbers.insert(key.numbers.end(), {p.x, p.y, p.z});
      }
      round(key.numbers, as_float && by_vertices);
      to.push_back({std::move(key), {i, t, std::nullopt}});
    }
  }

 private:
  Keyed<ProbePlace> solid(std::uint32_t i, std::string_view type, std::vector<double> numbers, bool as_float) const {
    round(numbers, as_float);
    return {{path(i), type, std::move(numbers)}, {i, std::nullopt, std::nullopt}};
  }

  static void round(std::vector<double>& numbers, bool as_float) {
    if (as_float)
      for (double& number : numbers) number = static_cast<float>(number);
  }

  std::string path(std::uint32_t i) const {
    if (!paths_) return "";
    std::string path = std::to_string(i);
    for (std::size_t group = 0; group < scene_[i].groups.size(); ++group) path += "/0";
    return path;
  }

  const SubjectScene& scene_;
  const Contract& contract_;
  bool paths_;
};

/// Two lists held against each other as multisets; equal ones pair up in their order.
struct Matching {
  std::vector<std::pair<std::size_t, ProbePlace>> pairs;  // place in the program's list, place in the scene
  std::vector<Key> superfluous;
  std::vector<Keyed<ProbePlace>> missing;
};

Matching match(std::vector<Keyed<std::size_t>> listed, std::vector<Keyed<ProbePlace>> expected) {
  const auto by_key = [](const auto& a, const auto& b) { return a.first < b.first; };
  std::ranges::stable_sort(listed, by_key);
  std::ranges::stable_sort(expected, by_key);
  Matching matching;
  auto have = listed.begin();
  auto want = expected.begin();
  while (have != listed.end() || want != expected.end()) {
    if (want == expected.end() || (have != listed.end() && have->first < want->first)) {
      matching.superfluous.push_back((have++)->first);
    } else if (have == listed.end() || want->first < have->first) {
      matching.missing.push_back(*want++);
    } else {
      matching.pairs.emplace_back((have++)->second, (want++)->second);
    }
  }
  return matching;
}

[[noreturn]] void different(const std::vector<Key>& superfluous, const std::vector<Keyed<ProbePlace>>& missing) {
  std::string text = "its surfaces are not those of the scene:";
  if (!missing.empty()) text += fmt::format(" it lacks {}, such as {}", missing.size(), to_string(missing[0].first));
  if (!superfluous.empty())
    text += fmt::format("{} {} are not in the scene, such as {}", missing.empty() ? "" : ";", superfluous.size(),
                        to_string(superfluous[0]));
  throw SubjectFailure(Verdict::fail, "surfaces", text);
}

}  // namespace

std::vector<ProbePlace> match_surfaces(const json& list, const SubjectScene& scene, const Contract& contract) {
  std::vector<Keyed<std::size_t>> whole;
  std::vector<Keyed<std::size_t>> triangles;
  for (const json& listed : list_of(list, "the list of surfaces")) {
    Key key = read_key(listed);
    auto& to = key.type == "Triangle" ? triangles : whole;
    to.emplace_back(std::move(key), whole.size() + triangles.size());
  }
  const bool paths = !list.empty() && list.front().contains("path");
  const bool by_vertices = !triangles.empty() && triangles.front().first.numbers.size() != 1;
  const Expected expected(scene, contract, paths);

  std::vector<Keyed<ProbePlace>> surfaces;
  for (std::uint32_t i = 0; i < scene.size(); ++i) surfaces.push_back(expected.whole(i));
  Matching matching = match(std::move(whole), std::move(surfaces));
  // A mesh that is not listed as one may be there as its triangles.
  if (!triangles.empty()) {
    std::vector<Keyed<ProbePlace>> of_meshes;
    std::ranges::sort(matching.missing, {}, [](const auto& missing) { return missing.second.surface; });
    std::erase_if(matching.missing, [&](const Keyed<ProbePlace>& missing) {
      if (!expected.is_mesh(missing.second.surface)) return false;
      expected.add_triangles(missing.second.surface, by_vertices, of_meshes);
      return true;
    });
    Matching of_triangles = match(std::move(triangles), std::move(of_meshes));
    std::ranges::move(of_triangles.pairs, std::back_inserter(matching.pairs));
    std::ranges::move(of_triangles.superfluous, std::back_inserter(matching.superfluous));
    std::ranges::move(of_triangles.missing, std::back_inserter(matching.missing));
  }
  if (!matching.superfluous.empty() || !matching.missing.empty()) different(matching.superfluous, matching.missing);
  std::vector<ProbePlace> places(matching.pairs.size());
  for (const auto& [listed, place] : matching.pairs) places[listed] = place;
  return places;
}

}  // namespace plumb

#include "tools/plumb/probe_answers.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "conformance/subject/probe_numbers.h"
#include "renderer/build_scene.h"
#include "renderer/film/render.h"
#include "renderer/kinds.h"
#include "renderer/math/frame.h"
#include "renderer/shaders/fresnel.h"
#include "scenes/load_meshes.h"
#include "scenes/read_scene.h"
#include "scenes/scene_kind.h"

namespace plumb {
namespace {

using nlohmann::json;

/// A surface as it stands in the file, in the order in which the scene places them.
struct Listed {
  std::string path;
  std::string_view type;
  std::vector<double> numbers;
  bool is_mesh = false;
};

void append_point(std::vector<double>& numbers, const Point3& p) { numbers.insert(numbers.end(), {p.x, p.y, p.z}); }

Listed listed(const ObjectDescription& surface, const std::string& path, const MeshTable& meshes) {
  Listed result{path, surface.kind->name, {}};
  std::vector<double>& numbers = result.numbers;
  if (result.type == "Mesh") {
    result.is_mesh = true;
    numbers = {static_cast<double>(meshes.at(surface.file_name("data"))->triangles.size())};
  } else if (result.type == "Box") {
    append_point(numbers, surface.point("minPt"));
    append_point(numbers, surface.point("maxPt"));
  } else if (result.type == "Sphere" || result.type == "Cylinder" || result.type == "Cone") {
    append_point(numbers, surface.point("center"));
    if (result.type == "Cone") numbers.push_back(surface.number("tipz"));
    numbers.push_back(surface.number("radius"));
    if (result.type != "Sphere") numbers.push_back(surface.number("height"));
  }
  return result;
}

/// The same walk as build_scene's.
void list_members(const ObjectDescription& group, const std::string& prefix, const MeshTable& meshes,
                  std::vector<Listed>& list) {
  std::size_t i = 0;
  for (const ObjectPointer& member : group.objects("surface")) {
    const std::string path = prefix + std::to_string(i++);
    if (member->kind == &group_kind) {
      list_members(*member, path + "/", meshes, list);
    } else {
      list.push_back(listed(*member, path, meshes));
    }
  }
}

/// A number of a question: JSON's own, or "inf" and "-inf".
double number_of(const json& value) {
  if (value == "inf") return std::numeric_limits<double>::infinity();
  if (value == "-inf") return -std::numeric_limits<double>::infinity();
  return value.get<double>();
}

template <std::size_t n>
std::array<double, n> numbers_of(const json& list) {
  if (!list.is_array() || list.size() != n)
    throw std::invalid_argument(fmt::format("expected a list of {} numbers", n));
  std::array<double, n> numbers;
  for (std::size_t i = 0; i < n; ++i) numbers[i] = number_of(list[i]);
  return numbers;
}

Ray ray_of(const json& list) {
  const auto [ox, oy, oz, dx, dy, dz, t_min, t_max] = numbers_of<8>(list);
  return {{ox, oy, oz}, {dx, dy, dz}, t_min, t_max};
}

/// `"KEY":[` what `write` appends for each item, with commas, `]`.
template <class List, class Write>
std::string list_text(std::string_view key, const List& items, Write write) {
  std::string text = fmt::format("\"{}\":[", key);
  bool first = true;
  for (const auto& item : items) {
    if (!first) text += ',';
    first = false;
    write(text, item);
  }
  return text + ']';
}

template <class Triple>
void append_list(std::string& text, const Triple& v) {
  text += '[';
  append_triple(text, v);
  text += ']';
}

void append_affine(std::string& text, const char* key, const AffineMatrix& m) {
  text += fmt::format("\"{}\":[", key);
  for (std::size_t row = 0; row < 3; ++row) {
    if (row > 0) text += ',';
    append_numbers(text, m[row]);
  }
  text += ']';
}

void append_inverse_transpose(std::string& text, const AffineMatrix& inverse) {
  text += "\"inverse_transpose\":[";
  for (std::size_t row = 0; row < 3; ++row) {
    if (row > 0) text += ',';
    append_numbers(text, std::array{inverse[0][row], inverse[1][row], inverse[2][row]});
  }
  text += ']';
}

void append_matrices(std::string& text, const PlacedSurface& placed) {
  text += '{';
  append_affine(text, "world", placed.world_from_object.matrix());
  text += ',';
  append_affine(text, "inverse", placed.world_from_object.inverse_matrix());
  text += ',';
  append_inverse_transpose(text, placed.world_from_object.inverse_matrix());
  text += '}';
}

Bounds3 bounds_of(const PlacedSurface& placed) { return placed.surface->world_bounds(placed.world_from_object); }

void append_fresnel(std::string& text, const json& query) {
  const auto [cosine, from, to] = numbers_of<3>(query);
  append_number(text, reflectance({cosine, from, to}, Fresnel::exact));
}

/// The normal is turned to the side that the direction comes from.
void append_refracted(std::string& text, const json& query) {
  const auto [dx, dy, dz, nx, ny, nz, from, to] = numbers_of<8>(query);
  const Vec3 to_viewer{-dx, -dy, -dz};
  Normal3 normal{nx, ny, nz};
  if (dot(normal, to_viewer) < 0) normal = -normal;
  const Interface interface { dot(normal, to_viewer), from, to };
  const std::optional<double> cosine = refracted_cosine(interface);
  if (!cosine) {
    text += "null";
    return;
  }
  append_list(text, refracted(to_viewer, normal, interface, *cosine));
}

void append_frame(std::string& text, const json& query) {
  const auto [x, y, z] = numbers_of<3>(query);
  text += '[';
  const char* comma = "";
  for (const Vec3& axis : frame_about({x, y, z})) {
    text += comma;
    append_triple(text, axis);
    comma = ",";
  }
  text += ']';
}

}  // namespace

struct ProbeAnswers::Loaded {
  Scene scene;
  std::vector<Listed> list;

  static std::unique_ptr<Loaded> load(const std::string& file) {
    const SceneDescription description = read_scene(file, renderer_kinds(Dialect::pa3_2011));
    const MeshTable meshes = load_meshes(description);
    std::vector<std::string> warnings;
    BuildOptions options;
    options.threads = 1;  // those who measure a probe expect a single one
    auto loaded = std::make_unique<Loaded>(Loaded{build_scene(description, meshes, options, warnings), {}});
    list_members(*description.scene, "", meshes, loaded->list);
    return loaded;
  }

  void append_hit(std::string& text, const Ray& ray, const Scene::Hit& hit) const {
    text += fmt::format("{{\"s\":{},\"t\":", hit.placed);
    append_number(text, hit.hit.t);
    if (list[hit.placed].is_mesh) {
      text += fmt::format(",\"p\":{},\"u\":", hit.hit.part);
      append_number(text, hit.hit.u);
      text += ",\"v\":";
      append_number(text, hit.hit.v);
    }
    text += ",\"n\":";
    append_list(text, scene.shading_point(ray, hit).normal);
    text += '}';
  }

  void append_closest(std::string& text, const json& query) const {
    const Ray ray = ray_of(query);
    TraceCounters counters;
    const std::optional<Scene::Hit> hit = scene.closest_hit(ray, counters);
    hit ? append_hit(text, ray, *hit) : void(text += "null");
  }

  /// Surface by surface, the next hit beyond each. Hits of one surface at the same t count once, and so do
  /// those of a mesh that its rounded t does not tell apart.
  void append_all(std::string& text, const json& query) const {
    const Ray ray = ray_of(query);
    TraceCounters counters;
    const char* comma = "";
    text += '[';
    for (std::uint32_t i = 0; i < scene.placed().size(); ++i) {
      const PlacedSurface& placed = scene.placed()[i];
      Ray rest = ray;
      while (const auto hit = placed.surface->intersect_placed(PlacedRay(rest, placed.world_from_object), counters)) {
        text += comma;
        append_hit(text, ray, {*hit, i});
        comma = ",";
        // The exact t of a triangle is not beyond its error.
        rest.t_min = std::nextafter(hit->t + hit->t_error, std::numeric_limits<double>::infinity());
      }
    }
    text += ']';
  }

  std::string surfaces() const {
    return list_text("surfaces", list, [](std::string& text, const Listed& surface) {
      text += fmt::format("{{\"type\":\"{}\",\"path\":\"{}\",\"numbers\":[", surface.type, surface.path);
      append_numbers(text, surface.numbers);
      text += "]}";
    });
  }

  void append_color(std::string& text, const json& pixel) const {
    const auto [x, y] = numbers_of<2>(pixel);
    const auto [width, height] = scene.image_size();
    if (!(x >= 0 && y >= 0 && x < width && y < height))
      throw std::invalid_argument("a pixel lies outside of the picture");
    const PixelRect crop{static_cast<int>(x), static_cast<int>(y), 1, 1};
    const Color color = render(scene, {.threads = 1, .crop = crop, .progress = {}}).image.at(0, 0);
    append_list(text, Vec3{color.r, color.g, color.b});
  }

  std::string answer(std::string_view ask, const json& question) const;
};

/// What is asked about the scene; empty for an unknown word.
std::string ProbeAnswers::Loaded::answer(std::string_view ask, const json& question) const {
  const auto by = [this](void (Loaded::*append)(std::string&, const json&) const) {
    return [this, append](std::string& text, const json& query) { (this->*append)(text, query); };
  };
  if (ask == "surfaces") return surfaces();
  if (ask == "bounds") {
    return list_text("bounds", scene.placed(), [](std::string& text, const PlacedSurface& placed) {
      const Bounds3 box = bounds_of(placed);
      text += '[';
      append_triple(text, box.min);
      text += ',';
      append_triple(text, box.max);
      text += ']';
    });
  }
  if (ask == "matrices") return list_text("matrices", scene.placed(), append_matrices);
  if (ask == "average_positions") {
    return list_text("average_positions", scene.placed(), [](std::string& text, const PlacedSurface& placed) {
      append_list(text, bounds_of(placed).center());
    });
  }
  if (ask == "closest") return list_text("hits", question.at("rays"), by(&Loaded::append_closest));
  if (ask == "all") return list_text("all", question.at("rays"), by(&Loaded::append_all));
  if (ask == "any") {
    return list_text("any", question.at("rays"), [this](std::string& text, const json& query) {
      TraceCounters counters;
      text += scene.blocks(ray_of(query), counters) ? '1' : '0';
    });
  }
  if (ask == "trace") return list_text("colors", question.at("pixels"), by(&Loaded::append_color));
  return "";
}

ProbeAnswers::ProbeAnswers() = default;
ProbeAnswers::~ProbeAnswers() = default;

std::string ProbeAnswers::greeting() {
  return R"({"plumb":1,"name":"plumb","precision":"double","t_precision":"double","float_meshes":true,)"
         R"("edges":"watertight","culling":"none","range":"closed","inside":"exit","surfaces":"tree",)"
         R"("shapes":["mesh","sphere","box","cylinder","cone"],)"
         R"("can":["bounds","matrices","average_position","normal","any","all","fresnel","refract","frame","trace"]})";
}

std::string ProbeAnswers::answer(const std::string& line) {
  std::string id = "null";
  std::string answer;
  const auto sentence = [](const char* key, std::string_view text) {
    return fmt::format("\"{}\":{}", key, json(text).dump(-1, ' ', false, json::error_handler_t::replace));
  };
  try {
    const json question = json::parse(line);
    id = question.at("id").dump();
    const std::string ask = question.at("ask").get<std::string>();
    if (ask == "quit") return "";
    if (ask == "load") {
      loaded_.reset();
      loaded_ = Loaded::load(question.at("scene").get<std::string>());
      answer = "\"ok\":true";
    } else if (ask == "fresnel") {
      answer = list_text("fresnel", question.at("queries"), append_fresnel);
    } else if (ask == "refract") {
      answer = list_text("refract", question.at("queries"), append_refracted);
    } else if (ask == "frame") {
      answer = list_text("frames", question.at("directions"), append_frame);
    } else if (!loaded_) {
      answer = sentence("error", "no scene is loaded");
    } else {
      answer = loaded_->answer(ask, question);
      if (answer.empty()) answer = sentence("unsupported", "there is no question '" + ask + "'");
    }
  } catch (const std::exception& error) {
    answer = sentence("error", error.what());
  }
  return fmt::format("{{\"plumb\":1,\"id\":{},{}}}", id, answer);
}

}  // namespace plumb

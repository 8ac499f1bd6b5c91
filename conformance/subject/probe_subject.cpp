#include "conformance/subject/probe_subject.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "conformance/subject/probe_greeting.h"
#include "conformance/subject/probe_hits.h"
#include "conformance/subject/probe_line.h"
#include "conformance/subject/probe_numbers.h"
#include "conformance/subject/probe_surfaces.h"
#include "conformance/subject/scene_file.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kChunk = 20'000;
/// Of rays whose every hit is asked, so that the answers stay within the longest line, and of pixels, which take long.
constexpr std::size_t kSmallChunk = 1'000;

fs::path make_folder() {
  std::string name = (fs::temp_directory_path() / "plumb-probe-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr)
    throw std::system_error(errno, std::generic_category(), "cannot make a folder for a probe's scene");
  return name;
}

void remove_folder(const fs::path& folder) {
  std::error_code ignored;
  if (!folder.empty()) fs::remove_all(folder, ignored);
}

unsigned shape_bit(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::triangle:
    case ShapeKind::mesh:
      return PLUMB_MESHES;
    case ShapeKind::sphere:
      return PLUMB_SPHERES;
    case ShapeKind::box:
      return PLUMB_BOXES;
    case ShapeKind::cylinder:
      return PLUMB_CYLINDERS;
    case ShapeKind::cone:
      return PLUMB_CONES;
  }
  throw std::logic_error("unknown kind of a shape");
}

std::size_t count_of_triangles(const SubjectScene& scene) {
  std::size_t count = 0;
  for (const SubjectSurface& surface : scene)
    if (const auto mesh = file_mesh(surface.shape)) count += mesh->triangles.size();
  return count;
}

void write_ray(std::string& text, const Ray& ray) {
  const double numbers[]{ray.origin.x,    ray.origin.y,    ray.origin.z, ray.direction.x,
                         ray.direction.y, ray.direction.z, ray.t_min,    ray.t_max};
  append_numbers(text, numbers);
}

}  // namespace

ProbeSubject::ProbeSubject(ProbeCommand command) : command_(std::move(command)) { start(); }

ProbeSubject::~ProbeSubject() { remove_folder(folder_); }

std::string ProbeSubject::description() const { return fmt::format("probe: {}", fmt::join(command_.arguments, " ")); }

/// A failure ends the program, and forgets what it held.
template <class Act>
auto ProbeSubject::guarded(Act act) {
  try {
    return act();
  } catch (const SubjectFailure&) {
    if (line_) failure_log_ = line_->abandon();
    line_.reset();
    loaded_ = false;
    places_.clear();
    throw;
  }
}

void ProbeSubject::rest() {
  if (line_) line_->abandon();
  line_.reset();
  loaded_ = false;
  places_.clear();
}

void ProbeSubject::start() {
  if (line_) return;
  guarded([&] {
    line_ = std::make_unique<ProbeLine>(command_);
    const ProbeGreeting greeting = read_greeting(line_->greeting());
    name_ = greeting.name;
    contract_ = greeting.contract;
    can_trace_ = greeting.can_trace;
  });
}

void ProbeSubject::require(bool ability, const char* what) const {
  if (!ability) throw UnsupportedBySubject(name_ + " does not answer " + what);
}

void ProbeSubject::require_scene() const {
  if (!loaded_) throw std::logic_error("ProbeSubject: asked about a scene before one was loaded");
}

void ProbeSubject::load(const SubjectScene& scene) {
  start();
  loaded_ = false;
  for (const SubjectSurface& surface : scene)
    if ((contract_.shapes & shape_bit(surface.shape.kind)) == 0)
      throw UnsupportedBySubject(name_ + " does not know a shape of the scene");
  // A folder of its own for each: a program may keep what it has read by its name.
  remove_folder(folder_);
  folder_.clear();
  folder_ = make_folder();
  const fs::path file = write_scene_file(scene, folder_);
  const std::size_t items = scene.size() + count_of_triangles(scene);
  guarded([&] {
    line_->ask({.ask = "load", .fields = "\"scene\":" + json(file.string()).dump(), .key = "ok", .items = items});
    const json list = line_->ask({.ask = "surfaces", .fields = "", .key = "surfaces", .items = items});
    places_ = match_surfaces(list, scene, contract_);
  });
  surface_count_ = scene.size();
  loaded_ = true;
}

void ProbeSubject::load_file(const fs::path& scene) {
  start();
  places_.clear();
  surface_count_ = 0;
  const std::string fields = "\"scene\":" + json(fs::absolute(scene).string()).dump();
  loaded_ = false;
  guarded([&] { line_->ask({.ask = "load", .fields = fields, .key = "ok"}); });
  loaded_ = true;
}

/// Asks about many things, chunk by chunk: `write` appends one of them, `read` takes in one of the answers.
template <class Item, class Write, class Read>
void ProbeSubject::ask_each(ProbeQuestion question, std::span<const Item> items, std::size_t chunk, Write write,
                            Read read) {
  start();
  const std::string begin = question.fields;
  for (std::size_t first = 0; first < items.size(); first += chunk) {
    const auto part = items.subspan(first, std::min(chunk, items.size() - first));
    question.fields = begin;
    for (std::size_t i = 0; i < part.size(); ++i) {
      question.fields += i == 0 ? "[" : ",[";
      write(question.fields, part[i]);
      question.fields += ']';
    }
    question.fields += ']';
    question.items = part.size();
    guarded([&] {
      const json answers = line_->ask(question);
      for (const json& answer : list_of(answers, part.size(), fmt::format("the answer to {}", question.ask)))
        read(answer);
    });
  }
}

std::vector<SubjectHit> ProbeSubject::closest(std::span<const Ray> rays) {
  require_scene();
  std::vector<SubjectHit> hits;
  hits.reserve(rays.size());
  ask_each({.ask = "closest", .fields = "\"rays\":[", .key = "hits"}, rays, kChunk, write_ray,
           [&](const json& answer) { hits.push_back(read_hit(answer, places_)); });
  return hits;
}

std::vector<std::uint8_t> ProbeSubject::any(std::span<const Ray> rays) {
  require(contract_.capabilities & PLUMB_ANY_HIT, "whether a ray hits anything");
  require_scene();
  std::vector<std::uint8_t> hits;
  ask_each({.ask = "any", .fields = "\"rays\":[", .key = "any"}, rays, kChunk, write_ray, [&](const json& answer) {
    hits.push_back(static_cast<std::uint8_t>(index_below(answer, 2, "whether there is a hit")));
  });
  return hits;
}

std::vector<std::vector<SubjectHit>> ProbeSubject::all(std::span<const Ray> rays) {
  require(contract_.capabilities & PLUMB_ALL_HITS, "all hits of a ray");
  require_scene();
  std::vector<std::vector<SubjectHit>> hits;
  ask_each({.ask = "all", .fields = "\"rays\":[", .key = "all", .seconds_an_item = 1e-2, .bytes_an_item = 1 << 16},
           rays, kSmallChunk, write_ray, [&](const json& answer) {
             std::vector<SubjectHit>& of_ray = hits.emplace_back();
             for (const json& hit : list_of(answer, "the hits of a ray")) {
               if (hit.is_null()) protocol_fault("a hit among all of a ray is null");
               of_ray.push_back(read_hit(hit, places_));
             }
           });
  return hits;
}

/// One thing for each surface of the program's list, `combine`d where several of them make one of the scene.
template <class Value, class Read, class Combine>
std::vector<Value> ProbeSubject::ask_places(const char* word, Read read, Combine combine) {
  require_scene();
  std::vector<Value> values(surface_count_);
  std::vector<std::size_t> seen(surface_count_, 0);
  guarded([&] {
    const json answers = line_->ask({.ask = word, .fields = "", .key = word, .items = places_.size()});
    list_of(answers, places_.size(), fmt::format("the answer to {}", word));
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const std::uint32_t surface = places_[i].surface;
      const Value value = read(answers[i]);
      values[surface] = seen[surface] == 0 ? value : combine(values[surface], value, seen[surface]);
      ++seen[surface];
    }
  });
  return values;
}

std::vector<Bounds3> ProbeSubject::bounds() {
  require(contract_.capabilities & PLUMB_BOUNDS, "bounds");
  return ask_places<Bounds3>("bounds", read_bounds, [](Bounds3 box, const Bounds3& more, std::size_t) {
    for (int axis = 0; axis < 3; ++axis) {
      box.min[axis] = std::min(box.min[axis], more.min[axis]);
      box.max[axis] = std::max(box.max[axis], more.max[axis]);
    }
    return box;
  });
}

std::vector<SubjectMatrices> ProbeSubject::matrices() {
  require(contract_.matrices, "matrices");
  return ask_places<SubjectMatrices>(
      "matrices", read_matrices, [](const SubjectMatrices& first, const SubjectMatrices& other, std::size_t) {
        if (first.world_from_object != other.world_from_object || first.inverse != other.inverse ||
            first.inverse_transpose != other.inverse_transpose)
          throw SubjectFailure(Verdict::fail, "surfaces", "the triangles of one mesh have different matrices");
        return first;
      });
}

std::vector<Point3> ProbeSubject::average_positions() {
  require(contract_.average_position, "average positions");
  return ask_places<Point3>(
      "average_positions", [](const json& answer) { return finite_triple<Point3>(answer, "an average position"); },
      [](const Point3& mean, const Point3& more, std::size_t before) {
        return mean + 1.0 / static_cast<double>(before + 1) * (more - mean);
      });
}

double ProbeSubject::fresnel(double cosine, double from, double to) {
  require(contract_.fresnel, "Fresnel reflectance");
  const std::array<double, 3> query{cosine, from, to};
  double reflectance = 0;
  ask_each({.ask = "fresnel", .fields = "\"queries\":[", .key = "fresnel"}, std::span(&query, 1), kChunk,
           append_numbers, [&](const json& answer) { reflectance = finite_number(answer, "a reflectance"); });
  return reflectance;
}

std::optional<Vec3> ProbeSubject::refract(const Vec3& direction, const Vec3& normal, double from, double to) {
  require(contract_.refract, "refraction");
  const std::array<double, 8> query{direction.x, direction.y, direction.z, normal.x, normal.y, normal.z, from, to};
  std::optional<Vec3> refracted;
  ask_each({.ask = "refract", .fields = "\"queries\":[", .key = "refract"}, std::span(&query, 1), kChunk,
           append_numbers, [&](const json& answer) {
             if (!answer.is_null()) refracted = finite_triple<Vec3>(answer, "a refracted direction");
           });
  return refracted;
}

std::array<Vec3, 3> ProbeSubject::frame(const Vec3& direction) {
  require(contract_.frame, "frames");
  std::array<Vec3, 3> frame;
  ask_each({.ask = "frame", .fields = "\"directions\":[", .key = "frames"}, std::span(&direction, 1), kChunk,
           append_triple<Vec3>, [&](const json& answer) {
             const std::vector<double> v = finite_numbers(answer, 9, "a frame");
             for (std::size_t i = 0; i < 3; ++i) frame[i] = {v[3 * i], v[3 * i + 1], v[3 * i + 2]};
           });
  return frame;
}

std::vector<Color> ProbeSubject::trace(std::span<const std::array<int, 2>> pixels) {
  require(can_trace_, "colours of pixels");
  require_scene();
  std::vector<Color> colors;
  ask_each(
      {.ask = "trace", .fields = "\"pixels\":[", .key = "colors", .seconds_an_item = 1e-1}, pixels, kSmallChunk,
      [](std::string& text, const std::array<int, 2>& pixel) { text += fmt::format("{},{}", pixel[0], pixel[1]); },
      [&](const json& answer) { colors.push_back(finite_triple<Color>(answer, "a colour")); });
  return colors;
}

}  // namespace plumb

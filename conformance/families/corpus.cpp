#include "conformance/families/corpus.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "conformance/kernel/plumb_corpus.h"
#include "reference/exact_hit.h"
#include "reference/triangle_oracle.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "a corpus is little endian");
static_assert(sizeof(plumb_corpus_header) == 48 && sizeof(plumb_corpus_record) == 424, "a corpus has no padding");

template <class Triple>
void put(double* to, const Triple& v) {
  to[0] = v.x;
  to[1] = v.y;
  to[2] = v.z;
}

void put_shape(const Shape& shape, plumb_corpus_record& record) {
  double* n = record.numbers;
  switch (shape.kind) {
    case ShapeKind::triangle:
      record.shape = PLUMB_CORPUS_TRIANGLE;
      for (std::size_t i = 0; i < 3; ++i) put(n + 3 * i, shape.vertices[i]);
      return;
    case ShapeKind::sphere:
      record.shape = PLUMB_CORPUS_SPHERE;
      put(n, shape.center);
      n[3] = shape.radius;
      return;
    case ShapeKind::box:
      record.shape = PLUMB_CORPUS_BOX;
      put(n, shape.min);
      put(n + 3, shape.max);
      return;
    case ShapeKind::cylinder:
      record.shape = PLUMB_CORPUS_CYLINDER;
      put(n, shape.center);
      n[3] = shape.radius;
      n[4] = shape.height;
      return;
    case ShapeKind::cone:
      record.shape = PLUMB_CORPUS_CONE;
      put(n, shape.center);
      n[3] = shape.tip_z;
      n[4] = shape.radius;
      n[5] = shape.height;
      return;
    case ShapeKind::mesh:
      throw std::logic_error("a corpus holds single surfaces");
  }
}

std::uint32_t class_of(HitClass hit_class) {
  switch (hit_class) {
    case HitClass::hit:
      return PLUMB_CORPUS_HIT;
    case HitClass::boundary:
      return PLUMB_CORPUS_BOUNDARY;
    case HitClass::tangent:
      return PLUMB_CORPUS_TANGENT;
    case HitClass::miss:
      return PLUMB_CORPUS_MISS;
    case HitClass::singular:
    case HitClass::unsupported:
      break;
  }
  throw std::logic_error("a family made a case that the oracle does not answer");
}

plumb_corpus_record record_of(const FamilyCase& one, const Ray& ray, plumb_precision precision) {
  plumb_corpus_record record{};
  const PlacedShape placed{one.surface.shape, one.surface.world_from_object};
  put_shape(placed.shape, record);
  for (std::size_t i = 0; i < 12; ++i) record.world_from_object[i] = placed.world_from_object[i / 4][i % 4];
  put(record.origin, ray.origin);
  put(record.direction, ray.direction);
  record.t_min = ray.t_min;
  record.t_max = ray.t_max;
  const ExactHit hit = exact_hit(placed, ray);
  record.hit_class = class_of(hit.hit_class);
  record.inside = hit.inside;
  record.crossing_count = static_cast<std::uint32_t>(hit.crossings.size());
  for (std::size_t i = 0; i < std::min<std::size_t>(hit.crossings.size(), 4); ++i) {
    const ExactCrossing& c = hit.crossings[i];
    std::uint32_t flags = 0;
    if (c.free) flags |= PLUMB_CORPUS_FREE;
    if (c.place == RangePlace::at_min) flags |= PLUMB_CORPUS_AT_MIN;
    if (c.place == RangePlace::at_max) flags |= PLUMB_CORPUS_AT_MAX;
    record.crossings[i] = {c.t.below, c.t.above, c.u, c.v, flags, c.part};
  }
  record.condition = one.condition;
  if (placed.shape.kind == ShapeKind::triangle) {
    const auto& [a, b, c] = placed.shape.vertices;
    record.margin = edge_margin(ray, a, b, c, precision == PLUMB_FLOAT ? 0x1p-24 : 0x1p-53);
  }
  return record;
}

template <class Object>
void write(std::ofstream& stream, const Object& object) {
  stream.write(reinterpret_cast<const char*>(&object), sizeof object);
}

}  // namespace

std::int64_t export_corpus(const CorpusRequest& request, const fs::path& file,
                           const std::function<void(double)>& progress) {
  if (request.family->make(request.seed, request.precision)->next().surface.shape.kind == ShapeKind::mesh)
    throw InputError({}, "a corpus holds single surfaces, and this family is made of meshes");
  const fs::path staged = file.string() + ".partial";
  std::ofstream stream(staged, std::ios::binary);
  plumb_corpus_header header{};
  std::memcpy(header.magic, PLUMB_CORPUS_MAGIC, sizeof header.magic);
  header.version = PLUMB_CORPUS_VERSION;
  header.record_size = sizeof(plumb_corpus_record);
  header.seed = request.seed;
  request.family->id.copy(header.family, sizeof header.family - 1);
  header.precision = request.precision;
  write(stream, header);
  const auto source = request.family->make(request.seed, request.precision);
  std::int64_t written = 0;
  while (written < request.count && stream) {
    const FamilyCase one = source->next();
    for (const Ray& ray : one.rays) write(stream, record_of(one, ray, request.precision));
    written += static_cast<std::int64_t>(one.rays.size());
    progress(static_cast<double>(written) / static_cast<double>(request.count));
  }
  header.count = static_cast<std::uint64_t>(written);
  stream.seekp(0);
  write(stream, header);
  stream.close();
  std::error_code error;
  if (stream) fs::rename(staged, file, error);
  if (!stream || error) {
    fs::remove(staged, error);
    throw InputError({file.string()}, "cannot be written");
  }
  return written;
}

}  // namespace plumb

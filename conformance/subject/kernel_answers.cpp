#include "conformance/subject/kernel_answers.h"

#include <fmt/format.h>

#include <cmath>

namespace plumb {
namespace {

[[noreturn]] void protocol(const std::string& sentence) { throw SubjectFailure(Verdict::fail, "protocol", sentence); }

void check_number(double value, const char* name, std::size_t ray) {
  if (std::bit_cast<std::uint64_t>(value) == kUnwrittenBits)
    protocol(fmt::format("{} of the hit of ray {} was left unwritten", name, ray));
  if (!std::isfinite(value))
    throw SubjectFailure(Verdict::fail, "not_finite", fmt::format("{} of the hit of ray {} is {}", name, ray, value));
}

SubjectHit checked_hit(const RawHits& hits, std::size_t i, std::size_t ray, std::span<const AskedSurface> surfaces) {
  SubjectHit hit;
  hit.surface = hits.surface[i];
  if (!hit.hit()) return hit;
  if (hit.surface == kUnwrittenIndex) protocol(fmt::format("the answer to ray {} was left unwritten", ray));
  if (hit.surface >= surfaces.size())
    protocol(fmt::format("ray {} hits surface {}, of {} that there are", ray, hit.surface, surfaces.size()));
  const AskedSurface& surface = surfaces[hit.surface];
  hit.primitive = hits.primitive[i];
  if (hit.primitive == kUnwrittenIndex) protocol(fmt::format("primitive of the hit of ray {} was left unwritten", ray));
  if (hit.primitive >= surface.primitives)
    protocol(fmt::format("ray {} hits primitive {} of surface {}, which has {}", ray, hit.primitive, hit.surface,
                         surface.primitives));
  hit.t = hits.t[i];
  check_number(hit.t, "t", ray);
  if (!surface.is_mesh) return hit;
  hit.u = hits.u[i];
  hit.v = hits.v[i];
  check_number(hit.u, "u", ray);
  check_number(hit.v, "v", ray);
  return hit;
}

}  // namespace

void RawHits::append(const RawHits& more, std::size_t begin, std::size_t end) {
  const auto add = [&](auto& to, const auto& from) {
    to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(begin),
              from.begin() + static_cast<std::ptrdiff_t>(end));
  };
  add(surface, more.surface);
  add(primitive, more.primitive);
  add(t, more.t);
  add(u, more.u);
  add(v, more.v);
}

void RawHits::write(KernelMessageWriter& message) const {
  message.put_all(surface);
  message.put_all(primitive);
  message.put_all(t);
  message.put_all(u);
  message.put_all(v);
}

RawHits RawHits::read(KernelMessageReader& message, std::uint64_t count) {
  RawHits hits;
  hits.surface = message.take_all<std::uint32_t>(count);
  hits.primitive = message.take_all<std::uint32_t>(count);
  hits.t = message.take_all<double>(count);
  hits.u = message.take_all<double>(count);
  hits.v = message.take_all<double>(count);
  return hits;
}

std::vector<AskedSurface> asked_surfaces(const KernelScene& scene) {
  std::vector<AskedSurface> asked;
  asked.reserve(scene.surfaces().size());
  for (const plumb_surface& surface : scene.surfaces()) {
    const bool is_mesh = surface.kind == PLUMB_MESH;
    asked.push_back({is_mesh, is_mesh ? surface.mesh.triangle_count : 1});
  }
  return asked;
}

std::vector<SubjectHit> checked_hits(const RawHits& hits, std::span<const AskedSurface> surfaces) {
  std::vector<SubjectHit> checked;
  checked.reserve(hits.count());
  for (std::size_t i = 0; i < hits.count(); ++i) checked.push_back(checked_hit(hits, i, i, surfaces));
  return checked;
}

std::vector<std::vector<SubjectHit>> checked_lists(const RawLists& lists, std::span<const AskedSurface> surfaces) {
  std::vector<std::vector<SubjectHit>> checked(lists.counts.size());
  std::size_t next = 0;
  for (std::size_t ray = 0; ray < checked.size(); ++ray) {
    for (std::uint32_t left = lists.counts[ray]; left > 0; --left, ++next) {
      if (next >= lists.hits.count()) protocol("there are fewer hits than the counts say");
      checked[ray].push_back(checked_hit(lists.hits, next, ray, surfaces));
      if (!checked[ray].back().hit()) protocol(fmt::format("a miss stands among the hits of ray {}", ray));
    }
  }
  if (next != lists.hits.count()) protocol("there are more hits than the counts say");
  return checked;
}

std::vector<std::uint8_t> checked_flags(std::vector<std::uint8_t> flags) {
  for (std::size_t ray = 0; ray < flags.size(); ++ray) {
    if (flags[ray] == kUnwrittenFlag) protocol(fmt::format("the answer to ray {} was left unwritten", ray));
    if (flags[ray] > 1) protocol(fmt::format("whether ray {} hits anything is {}, neither 0 nor 1", ray, flags[ray]));
  }
  return flags;
}

std::vector<Bounds3> checked_bounds(std::span<const double> numbers, std::span<const AskedSurface> surfaces) {
  if (numbers.size() != 6 * surfaces.size()) protocol("there are not six bounds a surface");
  std::vector<Bounds3> bounds;
  bounds.reserve(surfaces.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const std::span<const double> six = numbers.subspan(6 * i, 6);
    for (const double x : six) {
      if (std::bit_cast<std::uint64_t>(x) == kUnwrittenBits)
        protocol(fmt::format("bounds of surface {} were left unwritten", i));
      if (std::isnan(x) || (std::isinf(x) && surfaces[i].primitives > 0))
        throw SubjectFailure(Verdict::fail, "not_finite", fmt::format("a bound of surface {} is {}", i, x));
    }
    bounds.push_back({{six[0], six[1], six[2]}, {six[3], six[4], six[5]}});
  }
  return bounds;
}

}  // namespace plumb

#include "conformance/subject/probe_hits.h"

#include "conformance/subject/probe_numbers.h"

namespace plumb {

using nlohmann::json;

SubjectHit read_hit(const json& value, std::span<const ProbePlace> places) {
  if (value.is_null()) return {};
  const ProbePlace& place = places[index_below(member(value, "s", "a hit"), places.size(), "the surface of a hit")];
  SubjectHit hit;
  hit.surface = place.surface;
  hit.t = finite_number(member(value, "t", "a hit"), "t of a hit");
  if (place.triangle) {
    hit.primitive = *place.triangle;
  } else if (const auto p = value.find("p"); place.triangles && p != value.end()) {
    hit.primitive = static_cast<std::uint32_t>(index_below(*p, *place.triangles, "the triangle of a hit"));
  }
  const auto u = value.find("u");
  const auto v = value.find("v");
  hit.has_weights = u != value.end() && v != value.end();
  if (u != value.end()) hit.u = finite_number(*u, "u of a hit");
  if (v != value.end()) hit.v = finite_number(*v, "v of a hit");
  if (const auto normal = value.find("n"); normal != value.end())
    hit.normal = finite_triple<Vec3>(*normal, "the normal of a hit");
  return hit;
}

namespace {

AffineMatrix affine(const json& value, std::string_view what) {
  const std::vector<double> v = finite_numbers(value, 12, what);
  AffineMatrix matrix;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 4; ++column) matrix[row][column] = v[4 * row + column];
  return matrix;
}

}  // namespace

SubjectMatrices read_matrices(const json& value) {
  SubjectMatrices matrices;
  matrices.world_from_object = affine(member(value, "world", "a surface's matrices"), "a surface's matrix");
  matrices.inverse = affine(member(value, "inverse", "a surface's matrices"), "a surface's inverse matrix");
  const std::vector<double> v =
      finite_numbers(member(value, "inverse_transpose", "a surface's matrices"), 9, "a surface's inverse transpose");
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column) matrices.inverse_transpose[row][column] = v[3 * row + column];
  return matrices;
}

Bounds3 read_bounds(const json& value) {
  const std::vector<double> v = finite_numbers(value, 6, "a surface's bounds");
  return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
}

}  // namespace plumb

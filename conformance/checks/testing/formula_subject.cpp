#include "conformance/checks/testing/formula_subject.h"

#include <algorithm>
#include <cmath>

#include "reference/exact_bounds.h"
#include "reference/exact_hit.h"
#include "renderer/math/frame.h"
#include "renderer/shaders/fresnel.h"

namespace plumb::planted {
namespace {

std::vector<LocalHit> exact_hits(const Shape& shape, const Ray& ray) {
  std::vector<LocalHit> hits;
  for (const ExactCrossing& c : exact_hit({shape}, ray).crossings)
    hits.push_back({c.t_double, c.u, c.v, shape.kind == ShapeKind::mesh ? c.part : 0, c.normal});
  return hits;
}

SubjectMatrices matrices_of(const SubjectSurface& surface) {
  const Transform world_from_object(surface.world_from_object);
  SubjectMatrices matrices{world_from_object.matrix(), world_from_object.inverse_matrix(), {}};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column)
      matrices.inverse_transpose[row][column] = matrices.inverse[column][row];
  return matrices;
}

std::optional<Vec3> refracted_direction(const Vec3& direction, const Vec3& normal, double from, double to) {
  const Interface interface { - dot(direction, normal), from, to };
  const std::optional<double> cosine = refracted_cosine(interface);
  if (!cosine) return std::nullopt;
  return refracted(-direction, as_normal(normal), interface, *cosine);
}

Contract everything() {
  Contract contract;
  contract.shapes = PLUMB_MESHES | PLUMB_SPHERES | PLUMB_BOXES | PLUMB_CYLINDERS | PLUMB_CONES;
  contract.capabilities = PLUMB_TRANSFORMS | PLUMB_ANY_HIT | PLUMB_ALL_HITS | PLUMB_BOUNDS;
  contract.matrices = contract.fresnel = contract.refract = contract.frame = contract.average_position = true;
  return contract;
}

}  // namespace

Formulas right_formulas() {
  const auto box = [](const SubjectSurface& s) { return exact_bounds({s.shape, s.world_from_object}); };
  return {.contract = everything(),
          .into_object = [](const AffineMatrix& m, const Ray& ray) { return Transform(m).inverse_of(ray); },
          .hits = exact_hits,
          .normal_to_world = [](const AffineMatrix& m, const Normal3& n) { return as_vector(Transform(m)(n)); },
          .matrices = matrices_of,
          .bounds = box,
          .average_position = [box](const SubjectSurface& s) { return box(s).center(); },
          .fresnel =
              [](double cosine, double from, double to) {
                return reflectance({cosine, from, to}, Fresnel::exact);
              },
          .refract = refracted_direction,
          .frame = frame_about};
}

std::vector<SubjectHit> FormulaSubject::hits_of(const Ray& ray) const {
  std::vector<SubjectHit> found;
  for (std::size_t i = 0; i < scene_.size(); ++i) {
    const SubjectSurface& surface = scene_[i];
    const bool placed = surface.world_from_object != identity_matrix();
    const Ray own = placed ? formulas_.into_object(surface.world_from_object, ray) : ray;
    for (const LocalHit& hit : formulas_.hits(surface.shape, own)) {
      if (!std::isfinite(hit.t)) throw SubjectFailure(Verdict::fail, "not_finite", "t of a hit is no number");
      SubjectHit result{static_cast<std::uint32_t>(i), hit.primitive, hit.t, hit.u, hit.v, true, std::nullopt};
      if (hit.normal != Normal3{}) result.normal = formulas_.normal_to_world(surface.world_from_object, hit.normal);
      found.push_back(result);
    }
  }
  return found;
}

std::vector<SubjectHit> FormulaSubject::closest(std::span<const Ray> rays) {
  std::vector<SubjectHit> answers;
  for (const Ray& ray : rays) {
    const std::vector<SubjectHit> hits = hits_of(ray);
    answers.push_back(hits.empty() ? SubjectHit{} : *std::ranges::min_element(hits, {}, &SubjectHit::t));
  }
  return answers;
}

std::vector<std::uint8_t> FormulaSubject::any(std::span<const Ray> rays) {
  std::vector<std::uint8_t> answers;
  for (const Ray& ray : rays) answers.push_back(!hits_of(ray).empty());
  return answers;
}

std::vector<std::vector<SubjectHit>> FormulaSubject::all(std::span<const Ray> rays) {
  std::vector<std::vector<SubjectHit>> answers;
  for (const Ray& ray : rays) answers.push_back(hits_of(ray));
  return answers;
}

std::vector<Bounds3> FormulaSubject::bounds() {
  std::vector<Bounds3> boxes;
  for (const SubjectSurface& surface : scene_) boxes.push_back(formulas_.bounds(surface));
  return boxes;
}

std::vector<SubjectMatrices> FormulaSubject::matrices() {
  std::vector<SubjectMatrices> matrices;
  for (const SubjectSurface& surface : scene_) matrices.push_back(formulas_.matrices(surface));
  return matrices;
}

std::vector<Point3> FormulaSubject::average_positions() {
  std::vector<Point3> positions;
  for (const SubjectSurface& surface : scene_) positions.push_back(formulas_.average_position(surface));
  return positions;
}

}  // namespace plumb::planted

#include "conformance/checks/bounds_question.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "conformance/checks/class_question.h"
#include "conformance/checks/describe.h"
#include "conformance/checks/hit_judge.h"
#include "reference/exact_bounds.h"

namespace plumb {
namespace {

constexpr std::size_t kSurfacesOfAScene = 16;
constexpr double kSurfaces = 20'000;
constexpr double kLooseUnits = 4;
/// Past this the box of a box is suspected.
constexpr double kVeryLoose = 1e-3;

/// What was found of all boxes.
struct BoundsCounts {
  std::int64_t boxes = 0, cut = 0, loose = 0, faces_loose = 0;
  std::int64_t largest_ulps = 0;
  double largest_relative = 0;
  std::string worst_cut, worst_loose;
};

template <class Triple>
std::string triple(const Triple& v) {
  return hex(v.x) + " " + hex(v.y) + " " + hex(v.z);
}

std::string bounds_command(const PlacedShape& shape, const Bounds3& claimed) {
  std::string command = oracle_command(shape, Ray{});
  const std::string ray_word = "oracle ray";
  if (const auto at = command.find(ray_word); at != std::string::npos)
    command.replace(at, ray_word.size(), "oracle bounds");
  command.erase(std::min(command.find(" --origin"), command.size()));
  return fmt::format("{} --claimed {},{},{},{},{},{}", command, hex(claimed.min.x), hex(claimed.min.y),
                     hex(claimed.min.z), hex(claimed.max.x), hex(claimed.max.y), hex(claimed.max.z));
}

void judge_box(const PlacedShape& shape, const Bounds3& claimed, const Contract& contract, BoundsCounts& counts) {
  const BoundsVerdict verdict = judge_bounds(shape, claimed);
  ++counts.boxes;
  if (!verdict.contains) {
    if (counts.cut++ == 0) counts.worst_cut = bounds_command(shape, claimed);
    return;
  }
  const std::int64_t ulps = std::ranges::max(verdict.ulps_loose);
  counts.largest_ulps = std::max(counts.largest_ulps, ulps);
  counts.faces_loose += std::ranges::count_if(verdict.ulps_loose, [](std::int64_t face) { return face > 1; });
  const double unit = 2 * unit_roundoff(contract.precision);
  counts.loose += ulps > 1 && verdict.relative_looseness > kLooseUnits * unit;
  if (verdict.relative_looseness > counts.largest_relative || counts.worst_loose.empty()) {
    counts.largest_relative = verdict.relative_looseness;
    counts.worst_loose = bounds_command(shape, claimed);
  }
}

CheckResult verdict_of(const BoundsCounts& counts, const Contract& contract) {
  CheckResult result;
  result.verdict = Verdict::pass;
  result.evidence = {{"contract", to_string(contract)},
                     {"gold", std::string(counts.cut == 0 && counts.faces_loose == 0 ? "yes" : "no")},
                     {"boxes", counts.boxes},
                     {"cut_their_shape", counts.cut},
                     {"looser_than_4_units", counts.loose},
                     {"faces_looser_than_an_ulp", counts.faces_loose},
                     {"largest_looseness_ulps", counts.largest_ulps},
                     {"largest_looseness_relative", counts.largest_relative}};
  result.summary = fmt::format("{} boxes: {} cut their shape, {} are loose; the loosest by {:.2g} of its size",
                               counts.boxes, counts.cut, counts.loose, counts.largest_relative);
  result.margin = -static_cast<double>(counts.cut);
  if (!counts.worst_loose.empty()) result.evidence.emplace_back("loosest_explained_by", counts.worst_loose);
  if (counts.cut > 0) {
    result.verdict = Verdict::fail;
    result.cause = "not_contained";
    result.evidence.emplace_back("worst_explained_by", counts.worst_cut);
    result.advice =
        "a box leaves a part of its surface out, which a hierarchy then never looks at: " + counts.worst_cut;
  } else if (counts.loose > 0) {
    result.verdict = Verdict::quality_warning;
    result.cause = "loose";
    result.advice =
        counts.largest_relative > kVeryLoose
            ? "boxes are much larger than their surfaces, as the box of a transformed box is: " + counts.worst_loose
            : "boxes are looser than rounding asks for: " + counts.worst_loose;
  }
  return result;
}

}  // namespace

std::vector<SubjectScene> bounds_scenes(std::span<const std::string_view> families, const Subject& subject,
                                        const CheckOptions& options) {
  const Contract& contract = subject.contract();
  const double wanted = kSurfaces * options.intensity * subject.pace() / static_cast<double>(families.size());
  std::vector<SubjectScene> scenes;
  for (const std::string_view id : families) {
    const auto each = static_cast<std::int64_t>(std::ceil(wanted));
    const FamilyKind& family = family_kind(id);
    const ShapeKind kind = family.make(options.seed, contract.precision)->next().surface.shape.kind;
    const auto source = family.make(options.seed, family_precision(contract, kind));
    SubjectScene scene;
    for (std::int64_t i = 0; i < each; ++i) {
      FamilyCase one = source->next();
      if (can_build(contract, one.surface)) scene.push_back(std::move(one.surface));
      if (scene.size() == kSurfacesOfAScene || (i + 1 == each && !scene.empty()))
        scenes.push_back(std::exchange(scene, {}));
    }
  }
  if (scenes.empty()) throw UnsupportedBySubject(subject.name() + " builds none of these surfaces");
  return scenes;
}

std::vector<PlacedShape> placed_shapes(Subject& subject, const SubjectScene& scene) {
  std::vector<PlacedShape> shapes;
  const std::vector<SubjectMatrices> own =
      subject.contract().matrices ? subject.matrices() : std::vector<SubjectMatrices>();
  for (std::size_t i = 0; i < scene.size(); ++i)
    shapes.push_back({scene[i].shape, own.empty() ? scene[i].world_from_object : own[i].world_from_object});
  return shapes;
}

CheckResult check_bounds(std::span<const std::string_view> families, Subject& subject, const CheckOptions& options) {
  const std::vector<SubjectScene> scenes = bounds_scenes(families, subject, options);
  BoundsCounts counts;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    subject.load(scenes[i]);
    const std::vector<PlacedShape> shapes = placed_shapes(subject, scenes[i]);
    const std::vector<Bounds3> boxes = subject.bounds();
    for (std::size_t k = 0; k < shapes.size(); ++k) judge_box(shapes[k], boxes[k], subject.contract(), counts);
    options.progress(static_cast<double>(i + 1) / static_cast<double>(scenes.size()));
  }
  return verdict_of(counts, subject.contract());
}

CheckResult check_average_positions(std::span<const std::string_view> families, Subject& subject,
                                    const CheckOptions& options) {
  const std::vector<SubjectScene> scenes = bounds_scenes(families, subject, options);
  std::int64_t asked = 0, outside = 0;
  std::string worst;
  for (const SubjectScene& scene : scenes) {
    subject.load(scene);
    const std::vector<PlacedShape> shapes = placed_shapes(subject, scene);
    const std::vector<Point3> positions = subject.average_positions();
    for (std::size_t k = 0; k < shapes.size(); ++k) {
      ++asked;
      if (exact_bounds(shapes[k]).contains(positions[k])) continue;
      if (outside++ == 0)
        worst = fmt::format("({}) for {}", triple(positions[k]), bounds_command(shapes[k], exact_bounds(shapes[k])));
    }
  }
  CheckResult result;
  result.verdict = outside == 0 ? Verdict::pass : Verdict::fail;
  result.cause = outside == 0 ? "" : "outside";
  result.margin = -static_cast<double>(outside);
  result.evidence = {{"positions", asked}, {"outside", outside}};
  result.summary = fmt::format("{} average positions, {} outside of the surface's box", asked, outside);
  if (outside > 0) {
    result.evidence.emplace_back("worst", worst);
    result.advice =
        "averagePosition is in world space, as the box is; a hierarchy that sorts by it splits wrongly: " + worst;
  }
  return result;
}

}  // namespace plumb

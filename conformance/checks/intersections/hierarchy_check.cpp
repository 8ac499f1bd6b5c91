#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "conformance/checks/check.h"
#include "conformance/checks/class_question.h"
#include "conformance/checks/describe.h"
#include "conformance/families/random.h"
#include "conformance/families/rounding.h"

namespace plumb {
namespace {

constexpr double kScenes = 12;
constexpr std::size_t kTriangles = 240;
constexpr std::size_t kSolids = 40;
constexpr std::size_t kRays = 120;

/// What was compared, and where it differed.
struct Counts {
  std::int64_t scenes = 0, rays = 0, hits = 0, lost = 0, invented = 0, farther = 0, nearer = 0, blocked = 0;
  std::string worst;
  std::int64_t different() const { return lost + invented + farther + nearer; }
};

Point3 random_point(Random& random, const Contract& contract, double size) {
  Point3 p;
  for (int axis = 0; axis < 3; ++axis) p[axis] = random.between(-size, size);
  return Rounding(contract.float_meshes ? PLUMB_FLOAT : contract.precision)(p);
}

/// Triangles that share vertices, as those of a model do: each of three points that lie near together.
SubjectSurface triangle_soup(Random& random, const Contract& contract, std::size_t count) {
  auto mesh = std::make_shared<TriangleMesh>();
  for (std::size_t i = 0; i < count / 2 + 2; ++i) mesh->positions.push_back(random_point(random, contract, 1));
  while (mesh->triangles.size() < count) {
    const auto vertices = static_cast<std::uint32_t>(mesh->positions.size());
    const std::uint32_t a = random.below(vertices), b = random.below(vertices), c = random.below(vertices);
    if (a != b && b != c && c != a) mesh->triangles.push_back({a, b, c});
  }
  SubjectSurface surface;
  surface.shape.kind = ShapeKind::mesh;
  surface.shape.mesh = std::move(mesh);
  return surface;
}

/// The surfaces of families with and without groups, those that can be built.
SubjectScene solids(Random& random, const Contract& contract, std::size_t count) {
  static constexpr std::array<std::string_view, 5> kFamilies{"S0", "B0", "C0", "M0", "M2"};
  SubjectScene scene;
  for (const std::string_view id : kFamilies) {
    const auto family = family_kind(id).make(random.bits(), contract.precision);
    for (std::size_t i = 0; i < count / kFamilies.size(); ++i) {
      SubjectSurface surface = family->next().surface;
      if (surface.shape.kind != ShapeKind::mesh && surface.shape.kind != ShapeKind::triangle &&
          can_build(contract, surface))
        scene.push_back(std::move(surface));
    }
  }
  return scene;
}

/// From around at points within, half of them along an axis or with zeros; for meshes half of the rest at vertices.
std::vector<Ray> rays_at(Random& random, const Contract& contract, const TriangleMesh* mesh, std::size_t count) {
  std::vector<Ray> rays;
  while (rays.size() < count) {
    const Point3 origin = random_point(random, contract, 4);
    Point3 target = random_point(random, contract, 1);
    if (mesh && random.coin())
      target = mesh->positions[random.below(static_cast<std::uint32_t>(mesh->positions.size()))];
    Vec3 direction = target - origin;
    if (random.one_in(4)) direction[static_cast<int>(random.below(3))] = 0;
    direction = Rounding(contract.precision)(direction);
    if (length(direction) > 0) rays.push_back({origin, direction});
  }
  return rays;
}

/// Every primitive of a scene as a scene of its own.
std::vector<SubjectScene> primitives(const SubjectScene& scene) {
  std::vector<SubjectScene> singles;
  for (const SubjectSurface& surface : scene) {
    if (surface.shape.kind != ShapeKind::mesh) {
      singles.push_back({surface});
      continue;
    }
    for (const auto& [a, b, c] : surface.shape.mesh->triangles) {
      SubjectSurface single = surface;
      single.shape.kind = ShapeKind::triangle;
      const auto& p = surface.shape.mesh->positions;
      single.shape.vertices = {p[a], p[b], p[c]};
      single.shape.mesh = nullptr;
      singles.push_back({single});
    }
  }
  return singles;
}

std::string ray_text(const Ray& ray) {
  return fmt::format("origin {} {} {}, direction {} {} {}, t to {}", hex(ray.origin.x), hex(ray.origin.y),
                     hex(ray.origin.z), hex(ray.direction.x), hex(ray.direction.y), hex(ray.direction.z),
                     hex(ray.t_max));
}

/// Whether a t is the nearest, or farther by no more than two t may be off that the checks of t let pass, 64 units of
/// the last place each: a subject may tell its hits apart by something closer than the t that it reports.
bool is_nearest(double t, double nearest, const Contract& contract) {
  const double unit = std::ldexp(1.0, contract.t_precision == PLUMB_FLOAT ? -23 : -52);
  return t == nearest || (t > nearest && t - nearest <= 2 * 64 * unit * std::fabs(nearest));
}

void compare(const Ray& ray, const SubjectHit& found, const SubjectHit& nearest, const Contract& contract,
             Counts& counts) {
  ++counts.rays;
  counts.hits += nearest.hit();
  if (found.hit() == nearest.hit() && (!found.hit() || is_nearest(found.t, nearest.t, contract))) return;
  if (!found.hit())
    ++counts.lost;
  else if (!nearest.hit())
    ++counts.invented;
  else
    ++(found.t > nearest.t ? counts.farther : counts.nearer);
  if (counts.worst.empty())
    counts.worst = fmt::format("scene {}: {} instead of {} for {}", counts.scenes, describe(found), describe(nearest),
                               ray_text(ray));
}

/// The rays that hit, ended at half of the way to the nearest hit, or at twice it.
struct Ended {
  std::vector<Ray> rays;
  std::vector<SubjectHit> nearest;
};

Ended ended(const std::vector<Ray>& rays, const std::vector<SubjectHit>& nearest, const Contract& contract) {
  Ended result;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!nearest[i].hit() || !(nearest[i].t > 0)) continue;
    const bool behind = i % 2 == 1;
    Ray ray = rays[i];
    ray.t_max = Rounding(contract.precision)((behind ? 2 : 0.5) * nearest[i].t);
    result.rays.push_back(ray);
    result.nearest.push_back(behind ? nearest[i] : SubjectHit{});
  }
  return result;
}

/// `nearest` is what the surfaces by themselves answer.
void ask_rays(Subject& subject, std::span<const Ray> rays, std::span<const SubjectHit> nearest, Counts& counts) {
  const std::vector<SubjectHit> found = subject.closest(rays);
  for (std::size_t i = 0; i < rays.size(); ++i) compare(rays[i], found[i], nearest[i], subject.contract(), counts);
  if (!(subject.contract().capabilities & PLUMB_ANY_HIT)) return;
  const std::vector<std::uint8_t> any = subject.any(rays);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if ((any[i] != 0) == nearest[i].hit()) continue;
    if (counts.blocked++ == 0 && counts.worst.empty())
      counts.worst = fmt::format("scene {}: {} of `any` for {}", counts.scenes, any[i] != 0 ? "a hit" : "no hit",
                                 ray_text(rays[i]));
  }
}

void ask_scene(Subject& subject, const SubjectScene& scene, const std::vector<Ray>& rays, Counts& counts) {
  std::vector<Subject::Small> questions;
  for (SubjectScene& single : primitives(scene)) questions.push_back({std::move(single), rays});
  std::vector<SubjectHit> nearest(rays.size());
  for (const std::vector<SubjectHit>& answers : subject.closest_each(questions))
    for (std::size_t i = 0; i < rays.size(); ++i)
      if (answers[i].hit() && (!nearest[i].hit() || answers[i].t < nearest[i].t)) nearest[i] = answers[i];
  subject.load(scene);
  ask_rays(subject, rays, nearest, counts);
  const Ended short_rays = ended(rays, nearest, subject.contract());
  if (!short_rays.rays.empty()) ask_rays(subject, short_rays.rays, short_rays.nearest, counts);
  ++counts.scenes;
}

CheckResult run(Subject& subject, const CheckOptions& options) {
  const Contract& contract = subject.contract();
  const auto scenes = static_cast<std::int64_t>(std::ceil(kScenes * options.intensity * subject.pace()));
  const double fewer = std::sqrt(subject.pace());
  Counts counts;
  for (std::int64_t i = 0; i < scenes; ++i) {
    Random random(options.seed, "hierarchy", static_cast<std::uint64_t>(i));
    const auto some = [&](std::size_t count) {
      return static_cast<std::size_t>(std::ceil(static_cast<double>(count) * fewer));
    };
    if (contract.shapes & PLUMB_MESHES) {
      const SubjectScene scene{triangle_soup(random, contract, some(kTriangles))};
      ask_scene(subject, scene, rays_at(random, contract, scene[0].shape.mesh.get(), kRays), counts);
    }
    const SubjectScene scene = solids(random, contract, some(kSolids));
    if (!scene.empty()) ask_scene(subject, scene, rays_at(random, contract, nullptr, kRays), counts);
    options.progress(static_cast<double>(i + 1) / static_cast<double>(scenes));
  }
  if (counts.rays == 0) throw UnsupportedBySubject(subject.name() + " builds no surface of these scenes");

  CheckResult result;
  const std::int64_t different = counts.different() + counts.blocked;
  result.verdict = different == 0 ? Verdict::pass : Verdict::fail;
  result.cause = different == 0 ? "" : counts.different() > 0 ? "traversal" : "any_hit";
  result.margin = -static_cast<double>(different);
  result.evidence = {{"contract", to_string(contract)},
                     {"scenes", counts.scenes},
                     {"rays", counts.rays},
                     {"hits", counts.hits},
                     {"lost", counts.lost},
                     {"invented", counts.invented},
                     {"farther", counts.farther},
                     {"nearer", counts.nearer},
                     {"any_hit_differs", counts.blocked}};
  result.summary = fmt::format("{} rays at {} scenes: {} differ from trying each surface alone, {} of `any`",
                               counts.rays, counts.scenes, counts.different(), counts.blocked);
  if (different > 0) {
    result.evidence.emplace_back("worst", counts.worst);
    result.advice = "the search leaves out what a ray hits, or does not keep the nearest: " + counts.worst;
  }
  return result;
}

}  // namespace

extern const CheckKind hierarchy_check_kind{
    .id = "hierarchy",
    .title = "The hierarchy against trying everything",
    .asks =
        "Scenes of many triangles, and of many solids: is the closest hit that of the subject's own answers for each "
        "surface alone? Also for the same rays ended at half of the way to it, and at twice; and does any-hit agree?",
    .matters = "Triangles and whole objects are missing in blocks, or one behind shows through one in front.",
    .tolerance =
        "The subject's own primitives are asked one by one, so the hit must be the same. Which of two surfaces at the "
        "same t "
        "is free, and of two whose t are 128 units of the last place apart: the checks of t let each be off by 64, and "
        "a "
        "subject may order them by something closer.",
    .run = run,
};

}  // namespace plumb

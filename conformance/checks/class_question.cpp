#include "conformance/checks/class_question.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "conformance/checks/describe.h"
#include "conformance/checks/hit_judge.h"
#include "reference/triangle_oracle.h"

namespace plumb {
namespace {

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
  return 0;
}

/// How many of the usual questions are put in one message.
constexpr std::size_t kBatch = 512;

double largest_coordinate(const FamilyCase& question) {
  const Shape& shape = question.surface.shape;
  double largest = std::max({std::fabs(shape.radius), std::fabs(shape.height), std::fabs(shape.tip_z)});
  const auto extend = [&](const auto& p) {
    largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  };
  for (const Point3& p : shape.vertices) extend(p);
  for (const Point3& p : {shape.center, shape.min, shape.max}) extend(p);
  if (shape.mesh)
    for (const Point3& p : shape.mesh->positions) extend(p);
  for (const Ray& ray : question.rays) {
    extend(ray.origin);
    extend(ray.direction);
  }
  return largest;
}

class Asking {
 public:
  Asking(Subject& subject, CountedToo too, ClassCounts& counts) : subject_(subject), too_(too), counts_(counts) {}

  void ask(const std::vector<FamilyCase>& cases) {
    if (subject_.contract().matrices) {
      for (const FamilyCase& one : cases) ask_with_matrices(one);
      return;
    }
    std::vector<Subject::Small> questions;
    questions.reserve(cases.size());
    for (const FamilyCase& one : cases) questions.push_back({{one.surface}, one.rays});
    const std::vector<std::vector<SubjectHit>> answers = subject_.closest_each(questions);
    for (std::size_t i = 0; i < cases.size(); ++i)
      judge(cases[i], {cases[i].surface.shape, cases[i].surface.world_from_object}, answers[i]);
  }

 private:
  /// A probe multiplies its groups itself: its rays are judged by the matrix that it says it has (tier A); whether that
  /// one is right is the question of other checks.
  void ask_with_matrices(const FamilyCase& one) {
    subject_.load({one.surface});
    const AffineMatrix matrix =
        one.surface.groups.empty() ? identity_matrix() : subject_.matrices().at(0).world_from_object;
    judge(one, {one.surface.shape, matrix}, subject_.closest(one.rays));
  }

  void judge(const FamilyCase& one, const PlacedShape& shape, const std::vector<SubjectHit>& answers) {
    ++counts_.cases;
    for (std::size_t i = 0; i < one.rays.size(); ++i) judge_one(one, shape, one.rays[i], answers[i]);
  }

  void judge_one(const FamilyCase& one, const PlacedShape& shape, const Ray& ray, const SubjectHit& answer) {
    const Contract& contract = subject_.contract();
    const ExactHit truth = exact_hit(shape, ray);
    const AnswerJudgement judgement = judge_answer(truth, ray, shape.shape.kind, contract, answer);
    ++counts_.rays;
    counts_.hits += truth.crossings.empty() ? 0 : 1;
    counts_.free += judgement.free ? 1 : 0;
    int rank = 0;
    if (answer.hit() && !truth.crossings.empty()) {
      ++counts_.hits_told;
      counts_.distances += is_distance(answer.t, truth.crossings.front(), shape, ray, contract);
    }
    if (too_.near_hits && judgement.must_report && within_rounding(shape, ray, contract, one.condition, SubjectHit{})) {
      ++counts_.near_hits;
      counts_.near_misses += !answer.hit();
    }
    if (judgement.fault != AnswerFault::none) {
      counts_.false_misses += judgement.fault == AnswerFault::false_miss;
      counts_.false_hits += judgement.fault == AnswerFault::false_hit;
      counts_.wrong_crossings += judgement.fault == AnswerFault::wrong_crossing;
      const bool escape = judgement.must_hit && !answer.hit();
      const bool outside = !within_rounding(shape, ray, contract, one.condition, answer);
      counts_.escapes += escape;
      counts_.outside_band += outside;
      rank = outside ? 3 : escape ? 2 : 1;
    } else if (judgement.crossing && !judgement.free) {
      counts_.t_errors.push_back(judgement.t_ulps / one.condition);
      const ExactCrossing crossing = crossings_by_contract(truth, ray, shape.shape.kind, contract)[*judgement.crossing];
      if (too_.other_places && is_another_place(answer.t, crossing, shape, ray, contract)) {
        ++counts_.other_places;
        rank = 3;
      }
      if (answer.normal) judge_normal(crossing, *answer.normal);
    }
    note_worst(rank, rank == 0 && answer.hit() && !judgement.free ? judgement.t_ulps / one.condition : -1, shape, ray,
               truth, answer);
  }

  /// The side is that of the outward normal, or, for programs that turn normals to the viewer, consistently that: so
  /// only an angle to the line of the normal is off, and a flip is counted by itself.
  void judge_normal(const ExactCrossing& crossing, const Vec3& normal) {
    ++counts_.normals;
    const Vec3 exact = as_vector(crossing.normal);
    const double angle =
        std::atan2(length(cross(exact, normal)), std::fabs(dot(exact, normal))) * 180 / std::numbers::pi;
    counts_.normals_off += !(angle <= kNormalAngle);
    counts_.normals_flipped += dot(exact, normal) < 0;
    counts_.largest_normal_angle = std::max(counts_.largest_normal_angle, angle);
  }

  void note_worst(int rank, double t_error, const PlacedShape& shape, const Ray& ray, const ExactHit& truth,
                  const SubjectHit& answer) {
    ClassCounts::Worst& worst = counts_.worst;
    if (rank < worst.rank || (rank == worst.rank && (rank > 0 || t_error <= worst.t_error))) return;
    worst = {rank, t_error, 0, describe(truth), describe(answer), oracle_command(shape, ray)};
    if (shape.shape.kind == ShapeKind::triangle) {
      const auto& [a, b, c] = shape.shape.vertices;
      worst.margin_u = edge_margin(ray, a, b, c, unit_roundoff(subject_.contract().precision));
    }
  }

  Subject& subject_;
  CountedToo too_;
  ClassCounts& counts_;
};

}  // namespace

double ClassCounts::t_percentile(double share) const {
  if (t_errors.empty()) return 0;
  const auto last = static_cast<double>(t_errors.size() - 1);
  return t_errors[static_cast<std::size_t>(std::ceil(share * last))];
}

bool can_build(const Contract& contract, const SubjectSurface& surface) {
  if (!(contract.shapes & shape_bit(surface.shape.kind))) return false;
  // A probe is given groups, a kernel the matrix.
  if (contract.matrices) return surface.world_from_object == identity_matrix() || !surface.groups.empty();
  return surface.world_from_object == identity_matrix() || (contract.capabilities & PLUMB_TRANSFORMS);
}

plumb_precision family_precision(const Contract& contract, ShapeKind kind) {
  const bool through_files = contract.float_meshes && (kind == ShapeKind::triangle || kind == ShapeKind::mesh);
  return through_files ? PLUMB_FLOAT : contract.precision;
}

ClassCounts ask_family(Subject& subject, const FamilyKind& family, std::uint64_t seed, std::int64_t count,
                       const std::function<void(double)>& progress, CountedToo too) {
  const Contract& contract = subject.contract();
  const ShapeKind first_kind = family.make(seed, contract.precision)->next().surface.shape.kind;
  const auto source = family.make(seed, family_precision(contract, first_kind));
  ClassCounts counts;
  Asking asking(subject, too, counts);
  std::int64_t made = 0;
  while (made < count) {
    std::vector<FamilyCase> batch;
    while (batch.size() < kBatch && made < count) {
      FamilyCase one = source->next();
      made += static_cast<std::int64_t>(one.rays.size());
      if (!can_build(contract, one.surface)) continue;
      if (largest_coordinate(one) > contract.largest) {
        counts.too_large += static_cast<std::int64_t>(one.rays.size());
        continue;
      }
      batch.push_back(std::move(one));
    }
    if (!batch.empty()) asking.ask(batch);
    progress(static_cast<double>(made) / static_cast<double>(count));
  }
  if (counts.rays == 0)
    throw UnsupportedBySubject(subject.name() + " cannot build any surface of the family " + std::string(family.id));
  std::ranges::sort(counts.t_errors);
  return counts;
}

void add_evidence(const ClassCounts& counts, Evidence& evidence) {
  evidence.emplace_back("rays", counts.rays);
  evidence.emplace_back("surfaces", counts.cases);
  evidence.emplace_back("hits", counts.hits);
  evidence.emplace_back("free", counts.free);
  evidence.emplace_back("false_misses", counts.false_misses);
  evidence.emplace_back("false_hits", counts.false_hits);
  evidence.emplace_back("wrong_crossings", counts.wrong_crossings);
  evidence.emplace_back("outside_rounding", counts.outside_band);
  evidence.emplace_back("escapes", counts.escapes);
  if (counts.near_hits > 0) {
    evidence.emplace_back("hits_within_rounding", counts.near_hits);
    evidence.emplace_back("missed_of_those", counts.near_misses);
  }
  if (counts.other_places > 0) evidence.emplace_back("t_of_another_place", counts.other_places);
  if (counts.too_large > 0) evidence.emplace_back("left_out_too_large", counts.too_large);
  if (counts.distances > 0) evidence.emplace_back("t_is_a_distance", counts.distances);
  evidence.emplace_back("t_ulps_median", counts.t_percentile(0.5));
  evidence.emplace_back("t_ulps_p99", counts.t_percentile(0.99));
  evidence.emplace_back("t_ulps_largest", counts.t_percentile(1));
  if (counts.normals > 0) {
    evidence.emplace_back("normals", counts.normals);
    evidence.emplace_back("normals_off", counts.normals_off);
    evidence.emplace_back("normals_flipped", counts.normals_flipped);
    evidence.emplace_back("normals_largest_angle_degrees", counts.largest_normal_angle);
  }
  if (counts.worst.command.empty()) return;
  evidence.emplace_back("worst_truth", counts.worst.truth);
  evidence.emplace_back("worst_answer", counts.worst.answer);
  if (counts.worst.margin_u > 0) evidence.emplace_back("worst_distance_from_edge_u", counts.worst.margin_u);
  evidence.emplace_back("worst_explained_by", counts.worst.command);
}

}  // namespace plumb

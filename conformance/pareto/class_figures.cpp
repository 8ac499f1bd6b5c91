#include "conformance/pareto/class_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "conformance/checks/hit_judge.h"
#include "conformance/pareto/percentile.h"
#include "reference/triangle_oracle.h"

namespace plumb {
namespace {

/// How many cases are put in one message.
constexpr std::size_t kBatch = 512;

/// Of a triangle and its rays, directions too.
double largest_number(const FamilyCase& one) {
  double largest = 0;
  const auto extend = [&](const Point3& p) {
    for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, std::fabs(p[axis]));
  };
  if (one.surface.shape.kind == ShapeKind::triangle)
    for (const Point3& p : one.surface.shape.vertices) extend(p);
  for (const Ray& ray : one.rays) extend(ray.origin), extend(Point3{} + ray.direction);
  return largest;
}

bool all(const FamilyCase&, const Rounding&) { return true; }
bool huge(const FamilyCase& one, const Rounding&) { return largest_number(one) > 1; }
bool small(const FamilyCase& one, const Rounding&) { return largest_number(one) < 1; }
bool ill_conditioned_sphere(const FamilyCase& one, const Rounding& rounded) {
  return one.surface.shape.kind == ShapeKind::sphere && one.condition >= rounded.pick(1e2, 1e6);
}

constexpr std::array<ClassQuestion, 8> kTriangles{{{"T0", "control", all},
                                                   {"T1", "edge", all},
                                                   {"T2", "vertex", all},
                                                   {"T4", "grazing", all},
                                                   {"T5", "needle", all},
                                                   {"T7", "far", all},
                                                   {"T8", "huge", huge},
                                                   {"T8", "small", small}}};
constexpr std::array<ClassQuestion, 7> kSpheres{{{"S0", "control", all},
                                                 {"S1", "far", all},
                                                 {"S2", "huge", all},
                                                 {"S3", "tangent", all},
                                                 {"S4", "on sphere", all},
                                                 {"S5", "b = 0", all},
                                                 {"M1", "ill-conditioned", ill_conditioned_sphere}}};

/// Cases and their truth.
struct Batch {
  std::vector<FamilyCase> cases;
  std::vector<CaseTruth> truths;
  std::int64_t rays = 0;
};

Batch next_batch(Family& source, const ClassQuestion& question, const Rounding& rounded, std::int64_t count) {
  Batch batch;
  while (batch.cases.size() < kBatch && batch.rays < count) {
    FamilyCase one = source.next();
    if (!question.includes(one, rounded)) continue;
    batch.rays += static_cast<std::int64_t>(one.rays.size());
    batch.truths.emplace_back(one);
    batch.cases.push_back(std::move(one));
  }
  return batch;
}

void ask(Subject& subject, Batch& batch, ClassTally& tally) {
  std::vector<Subject::Small> questions;
  std::vector<std::size_t> asked;
  for (std::size_t i = 0; i < batch.cases.size(); ++i) {
    if (largest_number(batch.cases[i]) > subject.contract().largest) {
      tally.leave_out(batch.cases[i]);
      continue;
    }
    asked.push_back(i);
    questions.push_back({{batch.cases[i].surface}, batch.cases[i].rays});
  }
  if (questions.empty()) return;
  const std::vector<std::vector<SubjectHit>> answers = subject.closest_each(questions);
  for (std::size_t k = 0; k < asked.size(); ++k) tally.judge(batch.cases[asked[k]], batch.truths[asked[k]], answers[k]);
}

}  // namespace

std::span<const ClassQuestion> triangle_questions() { return kTriangles; }
std::span<const ClassQuestion> sphere_questions() { return kSpheres; }

CaseTruth::CaseTruth(const FamilyCase& one)
    : shape_{one.surface.shape, one.surface.world_from_object}, rays_(one.rays), margins_(one.rays.size(), -1.0) {
  hits_.reserve(rays_.size());
  for (const Ray& ray : rays_) hits_.push_back(exact_hit(shape_, ray));
}

double CaseTruth::margin(std::size_t ray, plumb_precision precision) {
  if (shape_.shape.kind != ShapeKind::triangle) return 0;
  double& margin = margins_[ray];
  if (margin < 0) {
    const auto& [a, b, c] = shape_.shape.vertices;
    margin = edge_margin(rays_[ray], a, b, c, unit_roundoff(PLUMB_FLOAT));
  }
  return margin * (unit_roundoff(PLUMB_FLOAT) / unit_roundoff(precision));
}

ClassTally::ClassTally(const ClassQuestion& question, const Contract& contract) : contract_(contract) {
  figure_.family = question.family;
  figure_.name = question.name;
}

void ClassTally::judge(const FamilyCase& one, CaseTruth& truth, std::span<const SubjectHit> answers) {
  for (std::size_t i = 0; i < one.rays.size(); ++i) {
    const AnswerJudgement judgement =
        judge_answer(truth.hit(i), one.rays[i], one.surface.shape.kind, contract_, answers[i]);
    ++figure_.rays;
    figure_.false_misses += judgement.fault == AnswerFault::false_miss;
    figure_.false_hits += judgement.fault == AnswerFault::false_hit;
    figure_.wrong_crossings += judgement.fault == AnswerFault::wrong_crossing;
    if (judgement.fault != AnswerFault::none) {
      figure_.farthest_u = std::max(figure_.farthest_u, truth.margin(i, contract_.precision));
    } else if (judgement.crossing && !judgement.free) {
      t_ulps_.push_back(judgement.t_ulps);
    }
  }
}

ClassFigure ClassTally::figure() && {
  std::ranges::sort(t_ulps_);
  figure_.right_hits = static_cast<std::int64_t>(t_ulps_.size());
  figure_.t_ulps_median = percentile(t_ulps_, 0.5);
  figure_.t_ulps_p99 = percentile(t_ulps_, 0.99);
  return std::move(figure_);
}

std::vector<ClassFigure> class_figures(std::span<Contender* const> contenders, const ClassQuestion& question,
                                       std::uint64_t seed, std::int64_t count,
                                       const std::function<void(double)>& progress) {
  if (contenders.empty()) return {};
  const plumb_precision inputs = contenders.front()->inputs;
  const Rounding rounded(inputs);
  const auto source = family_kind(question.family).make(seed, inputs);
  std::vector<std::optional<ClassTally>> tallies;
  for (const Contender* contender : contenders) {
    *contender->not_finite = 0;
    tallies.emplace_back(std::in_place, question, contender->subject->contract());
  }
  for (std::int64_t made = 0; made < count;) {
    Batch batch = next_batch(*source, question, rounded, count - made);
    made += batch.rays;
    for (std::size_t k = 0; k < contenders.size(); ++k) {
      if (!tallies[k]) continue;
      Contender& contender = *contenders[k];
      if (!contender.attempt(question.name, [&] { ask(*contender.subject, batch, *tallies[k]); })) tallies[k].reset();
    }
    progress(static_cast<double>(made) / static_cast<double>(count));
  }
  std::vector<ClassFigure> figures;
  for (std::optional<ClassTally>& tally : tallies) {
    if (!tally) tally.emplace(question, contenders.front()->subject->contract());
    figures.push_back(std::move(*tally).figure());
    figures.back().not_finite = std::exchange(*contenders[figures.size() - 1]->not_finite, 0);
  }
  return figures;
}

}  // namespace plumb

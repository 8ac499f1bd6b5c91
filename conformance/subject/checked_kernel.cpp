#include "conformance/subject/checked_kernel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plumb {
namespace {

/// Small scenes that are held, and sent, in their other form at a time.
constexpr std::size_t kQuestionsAtOnce = 4096;

/// Infinities, too, are floats. Volatile, because GCC 12 drops a plain rounding to float and back where it vectorises.
bool is_float(double x) {
  const volatile float rounded = static_cast<float>(x);
  return rounded == x;
}

bool is_identity(const plumb_surface& surface) {
  for (std::size_t i = 0; i < 12; ++i)
    if (surface.world_from_object[i] != (i % 5 == 0 ? 1 : 0)) return false;
  return true;
}

[[noreturn]] void no_float(double x) {
  throw std::invalid_argument("a kernel that computes in float was to be given " + fmt::format("{:a}", x) +
                              ", which is no float");
}

}  // namespace

CheckedKernel::CheckedKernel(std::unique_ptr<RawKernel> kernel, const std::filesystem::path& library)
    : kernel_(std::move(kernel)), contract_(checked_contract(kernel_->facts(), library)) {}

KernelScene CheckedKernel::supported(const SubjectScene& scene) const {
  KernelScene asked(scene);
  for (const plumb_surface& surface : asked.surfaces()) {
    if (!(contract_.shapes & (1u << surface.kind)))
      throw UnsupportedBySubject(name() + " does not know a shape of the scene");
    const bool placed = !is_identity(surface);
    if (placed && !(contract_.capabilities & PLUMB_TRANSFORMS))
      throw UnsupportedBySubject(name() + " does not transform surfaces");
    for_each_length(surface, [&](double x) {
      if (!(std::fabs(x) <= contract_.largest))
        throw UnsupportedBySubject(name() + " is not made for coordinates as large as the scene's");
      if (contract_.precision == PLUMB_FLOAT && !is_float(x)) no_float(x);
    });
    if (placed && contract_.precision == PLUMB_FLOAT) {
      const auto wrong = std::ranges::find_if_not(surface.world_from_object, is_float);
      if (wrong != std::end(surface.world_from_object)) no_float(*wrong);
    }
  }
  return asked;
}

KernelRays CheckedKernel::supported(std::span<const Ray> rays) const {
  for (const Ray& ray : rays) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!(std::fabs(ray.origin[axis]) <= contract_.largest) || !(std::fabs(ray.direction[axis]) <= contract_.largest))
        throw UnsupportedBySubject(name() + " is not made for rays with numbers as large");
    }
    if (contract_.precision != PLUMB_FLOAT) continue;
    for (const double x : {ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z,
                           ray.t_min, ray.t_max})
      if (!is_float(x)) no_float(x);
  }
  return KernelRays(rays);
}

void CheckedKernel::require_capability(unsigned capability, const char* what) const {
  if (!(contract_.capabilities & capability)) throw UnsupportedBySubject(name() + " does not answer " + what);
}

void CheckedKernel::require_scene() const {
  if (!loaded_) throw std::logic_error("no scene is loaded");
}

/// A kernel that failed is not asked again before it has been started afresh.
template <class Ask>
auto CheckedKernel::watched(Ask ask) {
  try {
    return ask();
  } catch (const SubjectFailure&) {
    loaded_ = false;
    kernel_->reset();
    throw;
  }
}

void CheckedKernel::rest() {
  loaded_ = false;
  kernel_->reset();
}

void CheckedKernel::load(const SubjectScene& scene) {
  loaded_ = false;
  const KernelScene asked = supported(scene);
  watched([&] { kernel_->load(asked); });
  surfaces_ = asked_surfaces(asked);
  loaded_ = true;
}

std::vector<SubjectHit> CheckedKernel::closest(std::span<const Ray> rays) {
  require_scene();
  const KernelRays asked = supported(rays);
  return watched([&] {
    const RawHits hits = kernel_->closest(asked);
    cpu_seconds_ = kernel_->cpu_seconds();
    return checked_hits(hits, surfaces_);
  });
}

std::vector<std::uint8_t> CheckedKernel::any(std::span<const Ray> rays) {
  require_capability(PLUMB_ANY_HIT, "whether a ray hits anything");
  require_scene();
  const KernelRays asked = supported(rays);
  return watched([&] { return checked_flags(kernel_->any(asked)); });
}

std::vector<std::vector<SubjectHit>> CheckedKernel::all(std::span<const Ray> rays) {
  require_capability(PLUMB_ALL_HITS, "all hits of a ray");
  require_scene();
  const KernelRays asked = supported(rays);
  return watched([&] { return checked_lists(kernel_->all(asked), surfaces_); });
}

std::vector<Bounds3> CheckedKernel::bounds() {
  require_capability(PLUMB_BOUNDS, "bounds");
  require_scene();
  return watched([&] { return checked_bounds(kernel_->bounds(), surfaces_); });
}

std::vector<std::vector<SubjectHit>> CheckedKernel::closest_each(std::span<const Small> questions) {
  std::vector<std::vector<SubjectHit>> answers;
  answers.reserve(questions.size());
  double seconds = 0;
  while (!questions.empty()) {
    const std::size_t count = std::min(kQuestionsAtOnce, questions.size());
    ask_each(questions.first(count), answers);
    questions = questions.subspan(count);
    seconds += kernel_->cpu_seconds();
  }
  cpu_seconds_ = seconds;
  return answers;
}

void CheckedKernel::ask_each(std::span<const Small> questions, std::vector<std::vector<SubjectHit>>& answers) {
  loaded_ = false;
  std::vector<RawKernel::Question> asked;
  asked.reserve(questions.size());
  for (const Small& question : questions) asked.push_back({supported(question.scene), supported(question.rays)});
  watched([&] {
    const std::vector<RawHits> raw = kernel_->closest_each(asked);
    for (std::size_t i = 0; i < raw.size(); ++i) {
      surfaces_ = asked_surfaces(asked[i].scene);
      answers.push_back(checked_hits(raw[i], surfaces_));
    }
  });
  loaded_ = true;
}

}  // namespace plumb

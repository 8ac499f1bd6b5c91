#include "conformance/subject/kernel_caller.h"

#include <time.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace plumb {
namespace {

/// Hits of one ray that are fetched at first; a ray with more of them is asked again by itself.
constexpr std::size_t kUsualHits = 16;
/// Rays that are asked for all hits in one call.
constexpr std::size_t kRaysForAll = 1024;
/// No ray of a scene that fits in memory has more.
constexpr std::uint32_t kMostHits = 1u << 24;

double process_cpu_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void require_intact(bool intact, const char* function) {
  if (!intact)
    throw SubjectFailure(Verdict::crash, "overrun", std::string(function) + " wrote beyond the arrays it was given");
}

/// The sentence that a kernel put into `error`, made one printable line.
std::string sentence_in(std::array<char, 512>& error) {
  std::string text(error.data(), ::strnlen(error.data(), error.size()));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  return text.empty() ? "it gave no reason" : text;
}

}  // namespace

plumb_hits KernelCaller::Arrays::prepare(std::size_t count) {
  return {surface.prepare(count, kUnwrittenIndex), primitive.prepare(count, kUnwrittenIndex),
          t.prepare(count, kUnwrittenNumber), u.prepare(count, kUnwrittenNumber), v.prepare(count, kUnwrittenNumber)};
}

bool KernelCaller::Arrays::intact() const {
  return surface.intact() && primitive.intact() && t.intact() && u.intact() && v.intact();
}

RawHits KernelCaller::Arrays::take() const { return {surface.take(), primitive.take(), t.take(), u.take(), v.take()}; }

const plumb_scene* KernelCaller::scene() const {
  if (!scene_) throw std::logic_error("no scene is loaded");
  return scene_.get();
}

void KernelCaller::load(const KernelScene& scene) {
  scene_.reset();
  const std::span<const plumb_surface> surfaces = scene.surfaces();
  std::array<char, 512> error{};
  plumb_scene* built = library_.table().build(surfaces.data(), surfaces.size(), error.data(), error.size());
  if (!built) throw SubjectFailure(Verdict::fail, "error", "the kernel refused the scene: " + sentence_in(error));
  scene_ = {built, Destroy{library_.table().destroy}};
  surfaces_ = surfaces.size();
}

RawHits KernelCaller::closest(const KernelRays& rays) {
  const plumb_rays view = rays.view();
  plumb_hits hits = arrays_.prepare(view.count);
  const plumb_scene* asked = scene();
  const double before = process_cpu_seconds();
  library_.table().closest_hit(asked, &view, &hits);
  cpu_seconds_ = process_cpu_seconds() - before;
  require_intact(arrays_.intact(), "closest_hit");
  return arrays_.take();
}

std::vector<std::uint8_t> KernelCaller::any(const KernelRays& rays) {
  const plumb_rays view = rays.view();
  GuardedArray<std::uint8_t> hit;
  std::uint8_t* to = hit.prepare(view.count, kUnwrittenFlag);
  library_.table().any_hit(scene(), &view, to);
  require_intact(hit.intact(), "any_hit");
  return hit.take();
}

RawLists KernelCaller::all(const KernelRays& rays) {
  RawLists lists;
  for (std::size_t begin = 0; begin < rays.count(); begin += kRaysForAll) {
    const std::size_t end = std::min(begin + kRaysForAll, rays.count());
    RawLists some;
    append_lists(rays.view(begin, end), kUsualHits, some);
    std::size_t from = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t count = some.counts[i - begin];
      const std::size_t there = std::min<std::size_t>(count, kUsualHits);
      if (count > kUsualHits) {
        append_lists(rays.view(i, i + 1), count, lists);
        if (lists.counts.back() != count)
          throw SubjectFailure(Verdict::fail, "protocol", "all_hits counts the same ray's hits differently");
      } else {
        lists.counts.push_back(count);
        lists.hits.append(some.hits, from, from + there);
      }
      from += there;
    }
  }
  return lists;
}

/// Asks once; of each ray at most `capacity` hits are appended, whatever its count.
void KernelCaller::append_lists(const plumb_rays& rays, std::size_t capacity, RawLists& lists) {
  plumb_hits hits = arrays_.prepare(rays.count * capacity);
  std::uint32_t* to = counts_.prepare(rays.count, kUnwrittenIndex);
  library_.table().all_hits(scene(), &rays, capacity, &hits, to);
  require_intact(arrays_.intact() && counts_.intact(), "all_hits");
  const RawHits all = arrays_.take();
  for (const std::uint32_t count : counts_.take()) {
    if (count > kMostHits)
      throw SubjectFailure(Verdict::fail, "protocol",
                           count == kUnwrittenIndex ? "the count of a ray's hits was left unwritten"
                                                    : "a ray has more hits than there can be");
    lists.counts.push_back(count);
  }
  const std::size_t first = lists.counts.size() - rays.count;
  for (std::size_t i = 0; i < rays.count; ++i)
    lists.hits.append(all, i * capacity, i * capacity + std::min<std::size_t>(lists.counts[first + i], capacity));
}

std::vector<double> KernelCaller::bounds() {
  GuardedArray<double> numbers;
  double* to = numbers.prepare(6 * surfaces_, kUnwrittenNumber);
  library_.table().bounds(scene(), to);
  require_intact(numbers.intact(), "bounds");
  return numbers.take();
}

std::vector<RawHits> KernelCaller::closest_each(std::span<const Question> questions) {
  std::vector<RawHits> answers;
  answers.reserve(questions.size());
  double sum = 0;
  for (const Question& question : questions) {
    load(question.scene);
    answers.push_back(closest(question.rays));
    sum += cpu_seconds_;
  }
  cpu_seconds_ = sum;
  return answers;
}

}  // namespace plumb

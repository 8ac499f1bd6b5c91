#include "conformance/pareto/tolerant_kernel.h"

#include <bit>
#include <cmath>

#include "conformance/subject/kernel_client.h"

namespace plumb {
namespace {

/// Passes questions on, and answers once they are rid of what is not finite.
class FiniteAnswers : public RawKernel {
 public:
  FiniteAnswers(const std::filesystem::path& library, std::shared_ptr<std::int64_t> not_finite)
      : client_(library, {}), not_finite_(std::move(not_finite)) {}

  const KernelFacts& facts() const override { return client_.facts(); }
  void load(const KernelScene& scene) override { client_.load(scene); }
  RawHits closest(const KernelRays& rays) override {
    RawHits hits = client_.closest(rays);
    *not_finite_ += drop_not_finite(hits);
    return hits;
  }
  std::vector<std::uint8_t> any(const KernelRays& rays) override { return client_.any(rays); }
  RawLists all(const KernelRays& rays) override { return client_.all(rays); }
  std::vector<double> bounds() override { return client_.bounds(); }
  std::vector<RawHits> closest_each(std::span<const Question> questions) override {
    std::vector<RawHits> answers = client_.closest_each(questions);
    for (RawHits& hits : answers) *not_finite_ += drop_not_finite(hits);
    return answers;
  }
  double cpu_seconds() const override { return client_.cpu_seconds(); }
  void reset() override { client_.reset(); }
  std::string log() const override { return client_.log(); }

 private:
  KernelClient client_;
  std::shared_ptr<std::int64_t> not_finite_;
};

bool is_written_but_not_finite(double x) {
  return !std::isfinite(x) && std::bit_cast<std::uint64_t>(x) != kUnwrittenBits;
}

}  // namespace

std::int64_t drop_not_finite(RawHits& hits) {
  std::int64_t dropped = 0;
  for (std::size_t i = 0; i < hits.count(); ++i) {
    if (hits.surface[i] == SubjectHit::kMiss || hits.surface[i] == kUnwrittenIndex) continue;
    if (!is_written_but_not_finite(hits.t[i]) && !is_written_but_not_finite(hits.u[i]) &&
        !is_written_but_not_finite(hits.v[i]))
      continue;
    hits.surface[i] = SubjectHit::kMiss;
    ++dropped;
  }
  return dropped;
}

TolerantKernel::TolerantKernel(const std::filesystem::path& library, std::shared_ptr<std::int64_t> not_finite)
    : CheckedKernel(std::make_unique<FiniteAnswers>(library, std::move(not_finite)), library) {}

}  // namespace plumb

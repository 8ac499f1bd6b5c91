#pragma once

#include "conformance/subject/raw_kernel.h"
#include "conformance/subject/subject.h"

namespace plumb {

/// What every kernel is as a Subject, wherever it runs: questions put into its terms, answers checked. A scene with
/// shapes, matrices or coordinates that the contract excludes is UnsupportedBySubject. Numbers that are no floats, for
/// a kernel that computes in float, are a std::invalid_argument: they break what plumb_kernel.h promises it. Asking
/// without a scene is a std::logic_error.
class CheckedKernel : public Subject {
 public:
  const std::string& name() const override { return kernel_->facts().name; }
  std::string description() const override { return kernel_->facts().description; }
  const Contract& contract() const override { return contract_; }
  void rest() override;
  void load(const SubjectScene& scene) override;
  std::vector<SubjectHit> closest(std::span<const Ray> rays) override;
  std::vector<std::uint8_t> any(std::span<const Ray> rays) override;
  std::vector<std::vector<SubjectHit>> all(std::span<const Ray> rays) override;
  std::vector<Bounds3> bounds() override;
  std::vector<std::vector<SubjectHit>> closest_each(std::span<const Small> questions) override;
  std::optional<double> last_cpu_seconds() const override { return cpu_seconds_; }

 protected:
  /// `library` is what an InputError names.
  CheckedKernel(std::unique_ptr<RawKernel> kernel, const std::filesystem::path& library);
  const RawKernel& raw() const { return *kernel_; }

 private:
  KernelScene supported(const SubjectScene& scene) const;
  KernelRays supported(std::span<const Ray> rays) const;
  void require_capability(unsigned capability, const char* what) const;
  void require_scene() const;
  template <class Ask>
  auto watched(Ask ask);
  void ask_each(std::span<const Small> questions, std::vector<std::vector<SubjectHit>>& answers);

  std::unique_ptr<RawKernel> kernel_;
  Contract contract_;
  bool loaded_ = false;
  std::vector<AskedSurface> surfaces_;
  std::optional<double> cpu_seconds_;
};

}  // namespace plumb

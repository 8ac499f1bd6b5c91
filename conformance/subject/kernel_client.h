#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "conformance/sandbox/log_capture.h"
#include "conformance/subject/kernel_process.h"
#include "conformance/subject/raw_kernel.h"

namespace plumb {

/// The program that hosts kernels, beside the program that runs now.
std::filesystem::path kernel_host_program();

struct KernelOptions {
  /// For any answer; the size of a question adds to it.
  double seconds = 10;
  std::int64_t memory_bytes = 4LL << 30;
  std::int64_t log_bytes = 1LL << 20;
  std::filesystem::path host = kernel_host_program();
};

/// A kernel in a process of its own, asked by messages.
class KernelClient : public RawKernel {
 public:
  /// Starts the process and reads what the kernel says of itself. Throws InputError, at the library, if the host
  /// refused it, and SubjectFailure if the process failed.
  KernelClient(const std::filesystem::path& library, const KernelOptions& options);

  const KernelFacts& facts() const override { return facts_; }
  /// Starts the process again if it was ended.
  void load(const KernelScene& scene) override;
  RawHits closest(const KernelRays& rays) override;
  std::vector<std::uint8_t> any(const KernelRays& rays) override;
  RawLists all(const KernelRays& rays) override;
  std::vector<double> bounds() override;
  std::vector<RawHits> closest_each(std::span<const Question> questions) override;
  double cpu_seconds() const override { return cpu_seconds_; }
  void reset() override { process_.reset(); }
  std::string log() const override { return log_.text(); }

 private:
  /// How much work a question is.
  struct Size {
    double rays = 0, primitives = 0;
  };
  double seconds_for(const Size& size) const;
  KernelFacts start();
  void ensure_started();
  /// Calls `read` with the answer. Throws SubjectFailure for any other message.
  template <class Read>
  auto ask(KernelMessageWriter& question, const Size& size, std::uint64_t most_bytes, Read read);

  std::filesystem::path library_;
  KernelOptions options_;
  LogCapture log_;
  std::unique_ptr<KernelProcess> process_;
  KernelFacts facts_;
  /// Of the scene that is loaded.
  double primitives_ = 0;
  std::size_t surfaces_ = 0;
  double cpu_seconds_ = 0;
};

}  // namespace plumb

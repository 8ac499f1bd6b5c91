#pragma once

#include <span>
#include <string>
#include <vector>

#include "conformance/subject/kernel_answers.h"
#include "conformance/subject/kernel_facts.h"
#include "conformance/subject/kernel_scene.h"

namespace plumb {

/// A kernel that is asked in its own terms, wherever it runs. Its answers have the right length; nothing else about
/// them is known. Each function throws SubjectFailure; then `reset` must come before the next `load`.
class RawKernel {
 public:
  struct Question {
    KernelScene scene;
    KernelRays rays;
  };

  virtual ~RawKernel() = default;

  virtual const KernelFacts& facts() const = 0;
  virtual void load(const KernelScene& scene) = 0;
  // Of the scene that was loaded last.
  virtual RawHits closest(const KernelRays& rays) = 0;
  virtual std::vector<std::uint8_t> any(const KernelRays& rays) = 0;
  virtual RawLists all(const KernelRays& rays) = 0;
  virtual std::vector<double> bounds() = 0;
  /// Loads and asks one after the other; the last scene stays loaded.
  virtual std::vector<RawHits> closest_each(std::span<const Question> questions) = 0;

  /// CPU seconds, of all threads, spent within the kernel's own closest_hit in the last closest or closest_each.
  virtual double cpu_seconds() const = 0;
  /// Gives up the scene and all that may have gone wrong with it.
  virtual void reset() = 0;
  /// What the kernel has printed, where that is kept apart from our own output.
  virtual std::string log() const { return ""; }
};

}  // namespace plumb

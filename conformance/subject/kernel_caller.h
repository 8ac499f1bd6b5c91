#pragma once

#include <cstring>
#include <memory>

#include "conformance/subject/kernel_library.h"
#include "conformance/subject/raw_kernel.h"

namespace plumb {

/// An array for a kernel to write to, filled with a value that says `unwritten`, between guards that say whether it
/// wrote too far.
template <class T>
class GuardedArray {
 public:
  T* prepare(std::size_t count, T unwritten) {
    count_ = count;
    cells_.assign(count + 2 * kGuard, unwritten);
    std::memset(cells_.data(), kPattern, kGuard * sizeof(T));
    std::memset(cells_.data() + kGuard + count, kPattern, kGuard * sizeof(T));
    return cells_.data() + kGuard;
  }
  bool intact() const {
    const auto is_guard = [&](std::size_t first) {
      const auto* bytes = reinterpret_cast<const unsigned char*>(cells_.data() + first);
      for (std::size_t i = 0; i < kGuard * sizeof(T); ++i)
        if (bytes[i] != kPattern) return false;
      return true;
    };
    return is_guard(0) && is_guard(kGuard + count_);
  }
  std::vector<T> take() const {
    const auto begin = cells_.begin() + static_cast<std::ptrdiff_t>(kGuard);
    return {begin, begin + static_cast<std::ptrdiff_t>(count_)};
  }

 private:
  static constexpr std::size_t kGuard = 64;
  static constexpr unsigned char kPattern = 0xc9;
  std::size_t count_ = 0;
  std::vector<T> cells_;
};

/// Calls the functions of a kernel's table in this process. A kernel that crashes or hangs does so here. Beyond what
/// RawKernel says, it throws SubjectFailure for a kernel that wrote beyond its arrays (crash, `overrun`: what it would
/// do to a program with another neighbour in memory), that does not build (fail, `error`, with its sentence), and that
/// counts differently each time it is asked (fail, `protocol`).
class KernelCaller : public RawKernel {
 public:
  explicit KernelCaller(const std::filesystem::path& library) : library_(library) {}

  const KernelFacts& facts() const override { return library_.facts(); }
  void load(const KernelScene& scene) override;
  RawHits closest(const KernelRays& rays) override;
  std::vector<std::uint8_t> any(const KernelRays& rays) override;
  RawLists all(const KernelRays& rays) override;
  std::vector<double> bounds() override;
  std::vector<RawHits> closest_each(std::span<const Question> questions) override;
  double cpu_seconds() const override { return cpu_seconds_; }
  void reset() override { scene_.reset(); }

 private:
  struct Destroy {
    void (*destroy)(plumb_scene*);
    void operator()(plumb_scene* scene) const { destroy(scene); }
  };
  struct Arrays {
    GuardedArray<std::uint32_t> surface, primitive;
    GuardedArray<double> t, u, v;
    plumb_hits prepare(std::size_t count);
    bool intact() const;
    RawHits take() const;
  };
  const plumb_scene* scene() const;
  void append_lists(const plumb_rays& rays, std::size_t capacity, RawLists& lists);

  KernelLibrary library_;
  std::unique_ptr<plumb_scene, Destroy> scene_;
  std::size_t surfaces_ = 0;
  double cpu_seconds_ = 0;
  // Kept from call to call, so that no call waits for memory.
  Arrays arrays_;
  GuardedArray<std::uint32_t> counts_;
};

}  // namespace plumb

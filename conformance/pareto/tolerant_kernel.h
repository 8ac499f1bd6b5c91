#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "conformance/subject/checked_kernel.h"

namespace plumb {

/// A kernel in a process of its own, as KernelSubject, but a hit with a number that is not finite does not end the
/// question: it stands as a miss, since nobody can go on with it, and is counted. A rate can be told of such a kernel.
class TolerantKernel : public CheckedKernel {
 public:
  /// Adds to `not_finite` the hits that were not. Throws as KernelSubject does.
  TolerantKernel(const std::filesystem::path& library, std::shared_ptr<std::int64_t> not_finite);
};

/// Turns hits whose t, u or v is an infinity or NaN into misses and returns how many they were. Those that were left
/// unwritten stay as they are.
std::int64_t drop_not_finite(RawHits& hits);

}  // namespace plumb

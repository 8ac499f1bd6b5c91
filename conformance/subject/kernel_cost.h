#pragma once

#include <cstddef>

#include "conformance/subject/subject.h"

namespace plumb {

/// What a ray costs without any work on it, by the number of rays that are asked at once.
struct AskingCost {
  /// In the process of the kernel, around its own function: part of every CPU time that is reported of a kernel.
  double cpu_nanoseconds_a_ray = 0;
  /// On the clock, from the question to the checked answer: what a run takes beyond the kernel's time.
  double clock_nanoseconds_a_ray = 0;
};

/// The medians over so many calls (> 0) of `closest` with as many rays (> 0) each, measured with a kernel that does
/// nothing (the shipped `empty`), to be printed beside the times of others. The subject's scene is replaced.
AskingCost asking_cost(Subject& nothing, std::size_t rays_a_call, int calls);

}  // namespace plumb

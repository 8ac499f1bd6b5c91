#pragma once

namespace plumb {

/// What wrong_kernel.cpp does wrong: a ray's t_max, or a sphere's radius.
enum class Wrong {
  nothing = 100,
  crash,
  abort,
  throws,
  hang,
  exits_with_zero,
  exits_with_three,
  closes_everything,
  writes_everywhere,
  takes_memory,
  prints,
  nan,
  nan_u,
  infinite,
  bad_surface,
  bad_primitive,
  bad_flag,
  overrun,
  underrun,
  leaves_all,
  leaves_t,
  leaves_v,
  counts_too_many,
  counts_differently,
  refuses,
  refuses_with_a_reason,
};

}  // namespace plumb

#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/subject/subject.h"

namespace plumb {

/// A kernel, and the precision of all numbers that it is asked with.
struct Contender {
  /// `mt-double`, or `mt-double/53` where a kernel of doubles is asked with numbers that use all of their bits.
  std::string name;
  plumb_precision inputs = PLUMB_FLOAT;
  std::unique_ptr<Subject> subject;
  /// What it did wrong as a program, a sentence each.
  std::vector<std::string> failures;
  /// Hits with numbers that were not finite, and therefore taken for misses (TolerantKernel).
  std::shared_ptr<std::int64_t> not_finite = std::make_shared<std::int64_t>(0);

  /// Calls `ask`. Where the subject fails or refuses, that is kept in `failures`, and false is returned.
  bool attempt(std::string_view what, const std::function<void()>& ask);
};

/// The contenders of one precision of inputs, in their order.
std::vector<Contender*> with_inputs(std::vector<Contender>& contenders, plumb_precision inputs);

/// Those names that match a GLOB, or one of several parted by commas; all for an empty one, and `always` where it is
/// among them. Throws InputError for a part that none matches.
std::vector<std::string> selected_kernels(const std::vector<std::string>& names, std::string_view filter,
                                          std::string_view always);

/// Of the shipped kernels with these names, those that know a shape (a bit of plumb_shape) and need have
/// `capabilities`: with float inputs first those of floats, then those of doubles; then those of doubles with inputs of
/// 53 bits. `empty` is none of them. Each has a process of its own.
std::vector<Contender> shipped_contenders(const std::vector<std::string>& names, unsigned shape, unsigned capabilities);

}  // namespace plumb

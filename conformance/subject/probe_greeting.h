#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "conformance/subject/contract.h"

namespace plumb {

/// What a probe says of itself in its first line.
struct ProbeGreeting {
  /// Letters, digits, '-', '_' and '.'.
  std::string name;
  Contract contract;
  bool can_trace = false;
};

/// Reads a greeting; what it leaves out is as docs/probe-protocol.md says. Unknown shapes and abilities are passed
/// over. Throws SubjectFailure (fail, `protocol`) for a value that is none of those known.
ProbeGreeting read_greeting(const nlohmann::json& greeting);

}  // namespace plumb

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "conformance/sandbox/run_outcome.h"

namespace plumb {

/// How a probe is started, and what it may use.
struct ProbeCommand {
  /// The program and its arguments, as in ProcessRequest.
  std::vector<std::string> arguments;
  /// Where it starts.
  std::filesystem::path folder;
  /// All of its environment, as NAME=VALUE; its private line is added.
  std::vector<std::string> environment;
  /// For the whole conversation. `wall_seconds` is how long one answer may take, beside what the question's size adds;
  /// no more than this for the greeting.
  RunLimits limits{.cpu_seconds = 600, .wall_seconds = 10};
};

}  // namespace plumb

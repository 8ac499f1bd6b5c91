#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "conformance/sandbox/session.h"
#include "conformance/subject/probe_command.h"

namespace plumb {

/// A question to a probe.
struct ProbeQuestion {
  std::string_view ask;
  /// What follows `ask` in the object: `"rays":[...]`; may be empty.
  std::string fields;
  /// Where the answer stands.
  const char* key;
  /// How many things are asked, and what each adds to the time and to the length that the answer may have.
  std::size_t items = 0;
  double seconds_an_item = 1e-3;
  std::size_t bytes_an_item = 1 << 10;
};

/// The conversation with a running probe (docs/probe-protocol.md): one question, one answer, faults as SubjectFailure.
/// After one the program is to be abandoned.
class ProbeLine {
 public:
  /// Starts the program and reads its greeting.
  explicit ProbeLine(const ProbeCommand& command);
  /// Asks the program to quit, and ends it if it does not.
  ~ProbeLine();
  ProbeLine(const ProbeLine&) = delete;
  ProbeLine& operator=(const ProbeLine&) = delete;

  const nlohmann::json& greeting() const { return greeting_; }
  /// What stands under the key. Throws UnsupportedBySubject if the program says so.
  nlohmann::json ask(const ProbeQuestion& question);
  /// Ends the program without a word. Returns what it has printed.
  std::string abandon();

 private:
  nlohmann::json exchange(const std::string& text, std::string_view name, double seconds, std::size_t longest);
  [[noreturn]] void fail(const SessionAnswer& answer, std::string_view name, double seconds);

  RunLimits limits_;
  std::optional<Session> session_;
  nlohmann::json greeting_;
  std::int64_t last_id_ = 0;
};

}  // namespace plumb

#pragma once

#include <memory>
#include <string>

namespace plumb {

/// Answers the questions of the probe protocol (docs/probe-protocol.md) about one scene at a time, from the renderer
/// itself.
class ProbeAnswers {
 public:
  ProbeAnswers();
  ~ProbeAnswers();

  /// What this program says of itself, a line without its LF.
  static std::string greeting();
  /// The answer to one question, both lines without LF; empty for `quit`. Never throws for a question that makes no
  /// sense: that is an `error`.
  std::string answer(const std::string& question);

 private:
  struct Loaded;
  std::unique_ptr<Loaded> loaded_;
};

}  // namespace plumb

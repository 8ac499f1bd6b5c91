#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

namespace plumb {

/// Cuts bytes into lines.
class LineSplitter {
 public:
  void append(std::string_view bytes);
  /// The next whole line, without its LF.
  std::optional<std::string> take();
  /// Bytes of the line that is not whole yet; right after `take` gave none.
  std::size_t pending() const { return bytes_.size() - begin_; }

 private:
  std::string bytes_;
  std::size_t begin_ = 0;
  std::size_t searched_ = 0;  // Up to here, from begin_, there is no LF.
};

/// Takes answers, lines with a prefix, out of a stream; everything else is log, and is never kept.
class AnswerFilter {
 public:
  explicit AnswerFilter(std::string prefix) : prefix_(std::move(prefix)) {}

  /// Takes in bytes; returns those of them that are log.
  std::string append(std::string_view bytes);
  std::optional<std::string> take();
  /// Bytes of a line that is not whole yet and has the prefix, or may come to have it.
  std::size_t pending() const { return line_.size(); }
  /// Whether that line has the prefix.
  bool in_answer() const { return line_.size() >= prefix_.size(); }
  /// Gives up: what was kept is log after all.
  std::string flush();

 private:
  std::string prefix_;
  std::deque<std::string> answers_;
  std::string line_;
  bool in_log_line_ = false;
};

}  // namespace plumb

#include "conformance/sandbox/answer_lines.h"

#include <algorithm>
#include <utility>

namespace plumb {

void LineSplitter::append(std::string_view bytes) {
  bytes_.erase(0, std::exchange(begin_, 0));
  bytes_.append(bytes);
}

std::optional<std::string> LineSplitter::take() {
  const std::size_t end = bytes_.find('\n', begin_ + searched_);
  if (end == std::string::npos) {
    searched_ = bytes_.size() - begin_;
    return std::nullopt;
  }
  std::string line = bytes_.substr(begin_, end - begin_);
  begin_ = end + 1;
  searched_ = 0;
  return line;
}

std::string AnswerFilter::append(std::string_view bytes) {
  std::string log;
  while (!bytes.empty()) {
    const std::size_t newline = bytes.find('\n');
    const bool whole = newline != std::string_view::npos;
    const std::string_view part = bytes.substr(0, whole ? newline : bytes.size());
    bytes.remove_prefix(part.size() + (whole ? 1 : 0));
    if (!in_log_line_) {
      line_.append(part);
      const std::size_t shown = std::min(line_.size(), prefix_.size());
      in_log_line_ = line_.compare(0, shown, prefix_, 0, shown) != 0 || (whole && shown < prefix_.size());
      if (in_log_line_) log += std::exchange(line_, {});
    } else {
      log += part;
    }
    if (!whole) break;
    if (in_log_line_) {
      log += '\n';
    } else {
      answers_.push_back(std::exchange(line_, {}));
    }
    in_log_line_ = false;
  }
  return log;
}

std::optional<std::string> AnswerFilter::take() {
  if (answers_.empty()) return std::nullopt;
  std::string answer = std::move(answers_.front());
  answers_.pop_front();
  return answer;
}

std::string AnswerFilter::flush() {
  std::string log;
  for (const std::string& answer : answers_) log += answer + '\n';
  answers_.clear();
  return log + std::exchange(line_, {});
}

}  // namespace plumb

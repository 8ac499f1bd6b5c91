#include "conformance/sandbox/log_capture.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>

namespace plumb {

LogCapture::LogCapture(std::int64_t cap) {
  const auto bytes = static_cast<std::size_t>(std::max<std::int64_t>(cap, 0));
  tail_cap_ = bytes / 2;
  head_cap_ = bytes - tail_cap_;
}

void LogCapture::append(std::string_view bytes) {
  total_ += static_cast<std::int64_t>(bytes.size());
  const std::size_t to_head = std::min(head_cap_ - head_.size(), bytes.size());
  head_.append(bytes.substr(0, to_head));
  bytes.remove_prefix(to_head);
  if (bytes.size() > tail_cap_) bytes.remove_prefix(bytes.size() - tail_cap_);
  const std::size_t to_grow = std::min(tail_cap_ - tail_.size(), bytes.size());
  tail_.append(bytes.substr(0, to_grow));
  bytes.remove_prefix(to_grow);
  while (!bytes.empty()) {
    const std::size_t piece = std::min(tail_cap_ - tail_next_, bytes.size());
    bytes.copy(tail_.data() + tail_next_, piece);
    bytes.remove_prefix(piece);
    tail_next_ = (tail_next_ + piece) % tail_cap_;
  }
}

std::int64_t LogCapture::dropped() const { return total_ - static_cast<std::int64_t>(head_.size() + tail_.size()); }

std::string LogCapture::text() const {
  std::string text = head_;
  if (const std::int64_t missing = dropped(); missing > 0) {
    if (!text.empty() && text.back() != '\n') text += '\n';
    text += "[" + std::to_string(missing) + (missing == 1 ? " byte" : " bytes") + " dropped]\n";
  }
  text.append(tail_, tail_next_);
  text.append(tail_, 0, tail_next_);
  return text;
}

bool drain(int descriptor, std::int64_t at_most, LogCapture& log) {
  std::array<char, 65'536> buffer;
  for (std::int64_t done = 0; done < at_most;) {
    const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno == EAGAIN;
    if (count == 0) return false;
    log.append({buffer.data(), static_cast<std::size_t>(count)});
    done += count;
  }
  return true;
}

}  // namespace plumb

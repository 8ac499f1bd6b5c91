#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace plumb {

/// Keeps the beginning and the end of a text of any length in a bounded space.
class LogCapture {
 public:
  /// Keeps at most `cap` bytes (>= 0; negative counts as 0): the first half of them and the last half.
  explicit LogCapture(std::int64_t cap);

  /// Adds bytes at the end; any values, also NUL.
  void append(std::string_view bytes);
  /// How many bytes were given and are not kept.
  std::int64_t dropped() const;
  /// What is kept; where bytes were dropped, a line `[N bytes dropped]` of its own stands between the halves.
  std::string text() const;

 private:
  std::size_t head_cap_;
  std::size_t tail_cap_;
  std::string head_;
  std::string tail_;           // A ring once it is full.
  std::size_t tail_next_ = 0;  // Where the ring's oldest byte stands and the next one goes.
  std::int64_t total_ = 0;
};

/// Moves what can be read from `descriptor` without waiting (it must be non-blocking) into `log`, but no more
/// than about `at_most` bytes, so that an endless writer cannot hold the caller. False once the other end is
/// closed for good or the descriptor is broken.
bool drain(int descriptor, std::int64_t at_most, LogCapture& log);

}  // namespace plumb

#pragma once

#include <unistd.h>

#include <utility>

namespace plumb {

/// Owns an open file of the system and closes it; -1 stands for none. Moved, never copied.
class FileDescriptor {
 public:
  explicit FileDescriptor(int number = -1) : number_(number) {}
  FileDescriptor(FileDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~FileDescriptor() { reset(); }

  /// The number, -1 if nothing is open.
  int get() const { return number_; }
  /// Whether something is open.
  bool valid() const { return number_ >= 0; }
  /// Closes what is open, if anything.
  void reset() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }
  /// Gives up ownership without closing.
  int release() { return std::exchange(number_, -1); }

 private:
  int number_;
};

}  // namespace plumb

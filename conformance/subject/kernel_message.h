#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace plumb {

/// What is asked of a kernel's host, and what it says. Numbers of the line, both ends being the same program's.
enum class KernelWord : std::uint32_t {
  // From the host, unasked: facts of the library, or why it cannot be used.
  facts = 1,
  refused,
  // Questions.
  load,
  closest,
  closest_each,
  any,
  all,
  bounds,
  // Answers.
  answer,
  failure,
};

/// In front of each message. What follows is `bytes` long.
struct KernelMessageHead {
  static constexpr std::uint32_t kMagic = 0x4b424c50;  // "PLBK" on the line
  std::uint32_t magic = kMagic;
  KernelWord word = KernelWord::failure;
  std::uint64_t bytes = 0;
};

/// A message that is not what it says: cut short, too long, or with a count that cannot be.
class KernelMessageFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

template <class T>
concept PlainNumbers = std::is_trivially_copyable_v<T>;

/// Puts a message together, its head in front.
class KernelMessageWriter {
 public:
  explicit KernelMessageWriter(KernelWord word) : bytes_(sizeof(KernelMessageHead)) { head_.word = word; }

  template <PlainNumbers T>
  void put(const T& value) {
    put_bytes(&value, sizeof value);
  }
  /// The numbers alone, without their count.
  template <PlainNumbers T>
  void put_all(const std::vector<T>& values) {
    put_bytes(values.data(), values.size() * sizeof(T));
  }
  void put_text(std::string_view text) {
    put<std::uint64_t>(text.size());
    put_bytes(text.data(), text.size());
  }
  std::size_t size() const { return bytes_.size(); }
  /// The whole message, ready to be sent.
  std::span<const std::byte> finish() {
    head_.bytes = bytes_.size() - sizeof head_;
    std::memcpy(bytes_.data(), &head_, sizeof head_);
    return bytes_;
  }

 private:
  void put_bytes(const void* from, std::size_t count) {
    const std::size_t end = bytes_.size();
    bytes_.resize(end + count);
    if (count > 0) std::memcpy(bytes_.data() + end, from, count);
  }

  KernelMessageHead head_;
  std::vector<std::byte> bytes_;
};

/// Takes a message apart. Throws KernelMessageFault where it is shorter than what is taken, or (`expect_end`) longer.
class KernelMessageReader {
 public:
  explicit KernelMessageReader(std::span<const std::byte> bytes) : rest_(bytes) {}

  template <PlainNumbers T>
  T take() {
    T value;
    std::memcpy(&value, take_bytes(1, sizeof value), sizeof value);
    return value;
  }
  template <PlainNumbers T>
  std::vector<T> take_all(std::uint64_t count) {
    const std::byte* from = take_bytes(count, sizeof(T));
    std::vector<T> values(count);
    if (count > 0) std::memcpy(values.data(), from, count * sizeof(T));
    return values;
  }
  std::string take_text() {
    const auto count = take<std::uint64_t>();
    const std::byte* from = take_bytes(count, 1);
    return {reinterpret_cast<const char*>(from), count};
  }
  void expect_end() const {
    if (!rest_.empty()) throw KernelMessageFault("a message is longer than what it holds");
  }

 private:
  const std::byte* take_bytes(std::uint64_t count, std::size_t size) {
    if (count > rest_.size() / size) throw KernelMessageFault("a message is shorter than what it should hold");
    const std::byte* from = rest_.data();
    rest_ = rest_.subspan(count * size);
    return from;
  }

  std::span<const std::byte> rest_;
};

}  // namespace plumb

#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>

namespace plumb {

/// Anonymous memory that takes space only where it was written: `bytes` of it, zero, at the start of a page, in huge
/// pages where the system has them; what is left over of the last of these is given back by shrink. Throws
/// std::bad_alloc.
class MappedMemory {
 public:
  MappedMemory() = default;
  explicit MappedMemory(std::size_t bytes);

  void* data() const { return memory_.get(); }
  /// Gives back all behind the first `bytes`.
  void shrink(std::size_t bytes);

 private:
  struct Unmap {
    std::size_t bytes;
    void operator()(void* memory) const;
  };
  std::unique_ptr<void, Unmap> memory_{nullptr, Unmap{0}};
};

/// An array in such memory, for a builder that knows only a loose bound of the length before.
template <class T>
class MappedArray {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  MappedArray() = default;
  explicit MappedArray(std::size_t most) : memory_(most * sizeof(T)), size_(most) {}

  T* data() const { return static_cast<T*>(memory_.data()); }
  T& operator[](std::size_t i) const { return data()[i]; }
  std::size_t size() const { return size_; }
  std::size_t bytes() const { return size_ * sizeof(T); }
  void shrink(std::size_t size) {
    memory_.shrink(size * sizeof(T));
    size_ = size;
  }

 private:
  MappedMemory memory_;
  std::size_t size_ = 0;
};

}  // namespace plumb

#include "renderer/accel/mapped_array.h"

#include <sys/mman.h>
#include <unistd.h>

#include <new>

namespace plumb {
namespace {

constexpr std::size_t kHugePage = std::size_t{1} << 21;

std::size_t whole(std::size_t page, std::size_t bytes) { return (bytes + page - 1) / page * page; }
std::size_t whole_pages(std::size_t bytes) { return whole(static_cast<std::size_t>(sysconf(_SC_PAGESIZE)), bytes); }

}  // namespace

MappedMemory::MappedMemory(std::size_t bytes) {
  // As many huge pages as it takes, not all but what is left over: shrinking gives back what was too much.
  bytes = bytes < kHugePage ? whole_pages(bytes) : whole(kHugePage, bytes);
  if (bytes == 0) return;
  void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  memory_ = {memory, Unmap{bytes}};
#ifdef MADV_HUGEPAGE
  madvise(memory, bytes, MADV_HUGEPAGE);  // a wish: where it is not granted, pages are small
#endif
}

void MappedMemory::shrink(std::size_t bytes) {
  const std::size_t kept = whole_pages(bytes);
  const std::size_t held = memory_.get_deleter().bytes;
  if (kept >= held) return;
  if (kept == 0) {
    memory_.reset();
    return;
  }
  munmap(static_cast<char*>(memory_.get()) + kept, held - kept);
  memory_.get_deleter().bytes = kept;
}

void MappedMemory::Unmap::operator()(void* memory) const {
  if (memory) munmap(memory, bytes);
}

}  // namespace plumb

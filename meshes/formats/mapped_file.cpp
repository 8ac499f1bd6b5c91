#include "meshes/formats/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "meshes/formats/file_bytes.h"

namespace plumb {
namespace {

class Descriptor {
 public:
  explicit Descriptor(const std::filesystem::path& file) : number_(::open(file.c_str(), O_RDONLY | O_CLOEXEC)) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

}  // namespace

MappedFile::MappedFile(const std::filesystem::path& file) {
  require_regular_file(file);  // before it is opened: opening a pipe waits for its writer
  const Descriptor descriptor(file);
  struct stat status {};
  if (descriptor.number() >= 0 && ::fstat(descriptor.number(), &status) == 0 && S_ISREG(status.st_mode) &&
      status.st_size > 0) {
    size_ = static_cast<std::size_t>(status.st_size);
    void* const address = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, descriptor.number(), 0);
    if (address != MAP_FAILED) {
      ::madvise(address, size_, MADV_SEQUENTIAL);  // a wish; nothing depends on it
      address_ = static_cast<const char*>(address);
      return;
    }
  }
  copy_ = file_bytes(file);
}

MappedFile::~MappedFile() {
  if (address_ != nullptr) ::munmap(const_cast<char*>(address_), size_);
}

}  // namespace plumb

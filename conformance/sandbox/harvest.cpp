#include "conformance/sandbox/harvest.h"

#include <fcntl.h>
#include <linux/openat2.h>
#include <sys/stat.h>
#include <sys/syscall.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "conformance/sandbox/file_descriptor.h"

namespace plumb {

namespace {

[[noreturn]] void fail(const std::string& what) { throw std::system_error(errno, std::generic_category(), what); }

std::string printable(const std::filesystem::path& path) {
  std::string text = path.string();
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  return text;
}

/// openat2 below `folder`; -1 with errno set.
int open_beneath(int folder, const std::filesystem::path& relative_path) {
  open_how how = {};
  how.flags = O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | O_NOCTTY;
  how.resolve = RESOLVE_BENEATH | RESOLVE_NO_SYMLINKS | RESOLVE_NO_MAGICLINKS;
  // With ".." in the path the kernel gives up with EAGAIN when anything was renamed meanwhile, anywhere.
  for (int attempt = 0;; ++attempt) {
    const long opened = ::syscall(SYS_openat2, folder, relative_path.c_str(), &how, sizeof how);
    if (opened >= 0 || (errno != EAGAIN && errno != EINTR) || attempt == 100) return static_cast<int>(opened);
  }
}

HarvestResult refusal(int error, const std::string& name) {
  switch (error) {
    case ELOOP:
      return {HarvestStatus::link, name + " is a symbolic link, or there is one on the way to it", 0};
    case EXDEV:
      return {HarvestStatus::link, name + " leads out of the folder", 0};
    case ENXIO:
    case ENODEV:
      return {HarvestStatus::not_regular, name + " is a socket or a device, not a file", 0};
    case ENOENT:
    case ENOTDIR:
    case ENAMETOOLONG:
      return {HarvestStatus::missing, name + " does not exist", 0};
    case EACCES:
    case EPERM:
      return {HarvestStatus::missing, name + " may not be read", 0};
    default:
      errno = error;
      fail("cannot open the output " + name);
  }
}

const char* kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  return "a device";
}

HarvestResult too_large(const std::string& name, std::int64_t max_bytes) {
  return {HarvestStatus::too_large, name + " is larger than the " + std::to_string(max_bytes) + " bytes allowed", 0};
}

/// Reads until the end or until more than `max_bytes` came, of which none beyond `max_bytes` is written. Returns
/// how many were read: more than `max_bytes` if the file is too large.
std::int64_t copy(int from, const std::string& name, int to, const std::string& destination, std::int64_t max_bytes) {
  std::array<char, 65'536> buffer;
  std::int64_t total = 0;
  for (;;) {
    const std::int64_t wanted = std::min<std::int64_t>(buffer.size() - 1, max_bytes - total) + 1;
    const ssize_t count = ::read(from, buffer.data(), static_cast<std::size_t>(wanted));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail("cannot read " + name);
    total += count;
    if (count == 0 || total > max_bytes) return total;
    for (std::string_view rest(buffer.data(), static_cast<std::size_t>(count)); !rest.empty();) {
      const ssize_t written = ::write(to, rest.data(), rest.size());
      if (written < 0 && errno != EINTR) fail("cannot write " + destination);
      if (written > 0) rest.remove_prefix(static_cast<std::size_t>(written));
    }
  }
}

/// The destination under a name of its own until it is whole; unless renamed, deleted.
class StagedFile {
 public:
  explicit StagedFile(const std::filesystem::path& destination)
      : destination_(destination), staged_(destination.string() + ".partial") {
    file_ = FileDescriptor(::open(staged_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0644));
    if (!file_.valid()) fail("cannot write " + staged_);
  }
  StagedFile(const StagedFile&) = delete;
  StagedFile& operator=(const StagedFile&) = delete;
  ~StagedFile() {
    if (!done_) ::unlink(staged_.c_str());
  }
  int descriptor() const { return file_.get(); }
  const std::string& name() const { return staged_; }
  void finish() {
    if (::close(file_.release()) != 0) fail("cannot write " + staged_);
    if (std::rename(staged_.c_str(), destination_.c_str()) != 0) fail("cannot write " + destination_.string());
    done_ = true;
  }

 private:
  std::filesystem::path destination_;
  std::string staged_;
  FileDescriptor file_;
  bool done_ = false;
};

}  // namespace

const char* to_string(HarvestStatus status) {
  switch (status) {
    case HarvestStatus::copied:
      return "copied";
    case HarvestStatus::missing:
      return "missing";
    case HarvestStatus::not_regular:
      return "not_regular";
    case HarvestStatus::link:
      return "link";
    case HarvestStatus::too_large:
      return "too_large";
  }
  return "?";
}

HarvestResult harvest(const std::filesystem::path& folder, const std::filesystem::path& relative_path,
                      std::int64_t max_bytes, const std::filesystem::path& destination) {
  if (relative_path.empty()) throw std::invalid_argument("harvest: the path of the output is empty");
  if (max_bytes < 0) throw std::invalid_argument("harvest: the largest size is negative");
  const std::string name = printable(relative_path);

  struct stat status;
  if (::lstat(folder.c_str(), &status) == 0 && S_ISLNK(status.st_mode)) {
    return {HarvestStatus::link, "the folder of " + name + " is a symbolic link", 0};
  }
  const FileDescriptor top(::open(folder.c_str(), O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (!top.valid()) return refusal(errno, name);
  const FileDescriptor file(open_beneath(top.get(), relative_path));
  if (!file.valid()) return refusal(errno, name);

  if (::fstat(file.get(), &status) != 0) fail("cannot look at the output " + name);
  if (!S_ISREG(status.st_mode)) {
    return {HarvestStatus::not_regular, name + " is " + kind_of(status.st_mode) + ", not a file", 0};
  }
  if (status.st_nlink != 1) {
    return {HarvestStatus::link, name + " has more than one name (a hard link), or none any more", 0};
  }
  if (status.st_size > max_bytes) return too_large(name, max_bytes);

  StagedFile staged(destination);
  const std::int64_t bytes = copy(file.get(), name, staged.descriptor(), staged.name(), max_bytes);
  if (bytes > max_bytes) return too_large(name, max_bytes);
  staged.finish();
  return {HarvestStatus::copied, name + " has " + std::to_string(bytes) + " bytes", bytes};
}

}  // namespace plumb

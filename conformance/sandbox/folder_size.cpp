#include "conformance/sandbox/folder_size.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <set>
#include <system_error>
#include <utility>

namespace plumb {

namespace {

constexpr int kFolderFlags = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;
constexpr std::int64_t kBlockBytes = 512;  // The unit of st_blocks, whatever the file system.

struct Count {
  FolderSize size;
  std::int64_t max_entries;
  std::set<std::pair<dev_t, ino_t>> several_names;
};

void count_file(const struct stat& status, Count& count) {
  if (status.st_nlink > 1 && !count.several_names.emplace(status.st_dev, status.st_ino).second) return;
  const std::int64_t room = std::max<std::int64_t>(status.st_size, status.st_blocks * kBlockBytes);
  const std::int64_t left = std::numeric_limits<std::int64_t>::max() - count.size.bytes;
  count.size.bytes += std::min(room, left);
}

void count_folder(int folder, int depth, Count& count) {
  DIR* const entries = ::fdopendir(folder);  // Takes the descriptor over.
  if (entries == nullptr) {
    ::close(folder);
    count.size.complete = false;
    return;
  }
  while (count.size.complete) {
    const dirent* const entry = ::readdir(entries);
    if (entry == nullptr) break;
    if (std::strcmp(entry->d_name, ".") == 0 || std::strcmp(entry->d_name, "..") == 0) continue;
    struct stat status;
    if (::fstatat(::dirfd(entries), entry->d_name, &status, AT_SYMLINK_NOFOLLOW) != 0) {
      if (errno != ENOENT) count.size.complete = false;
      continue;
    }
    if (++count.size.entries > count.max_entries) count.size.complete = false;
    if (S_ISREG(status.st_mode)) count_file(status, count);
    if (!S_ISDIR(status.st_mode)) continue;
    const int below = depth < FolderWatch::kMaxDepth ? ::openat(::dirfd(entries), entry->d_name, kFolderFlags) : -1;
    if (below >= 0) {
      count_folder(below, depth + 1, count);
    } else if (depth >= FolderWatch::kMaxDepth || (errno != ENOENT && errno != ENOTDIR && errno != ELOOP)) {
      // Gone, or no folder any more, is the subject's right; one that hides what it holds is not.
      count.size.complete = false;
    }
  }
  ::closedir(entries);
}

}  // namespace

FolderWatch::FolderWatch(const std::filesystem::path& folder, std::int64_t max_entries)
    : folder_(::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC)), max_entries_(max_entries) {
  if (!folder_.valid())
    throw std::system_error(errno, std::generic_category(), "cannot open folder " + folder.string());
}

FolderSize FolderWatch::measure() const {
  Count count{{}, max_entries_, {}};
  const int top = ::openat(folder_.get(), ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (top >= 0) {
    count_folder(top, 1, count);
  } else {
    count.size.complete = errno == ENOENT;  // The folder itself may have been deleted: then it holds nothing.
  }
  return count.size;
}

}  // namespace plumb

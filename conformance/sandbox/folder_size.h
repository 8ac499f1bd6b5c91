#pragma once

#include <cstdint>
#include <filesystem>

#include "conformance/sandbox/file_descriptor.h"

namespace plumb {

/// What stands below a folder.
struct FolderSize {
  /// Of regular files, each as the larger of its length and the room it takes on the disk, so that neither holes
  /// nor preallocation hide anything; several names of one file count once. Sums stop at the largest int64.
  std::int64_t bytes = 0;
  /// Everything that has a name: files, folders, links, pipes.
  std::int64_t entries = 0;
  /// False if the count was given up: too many entries, a folder that cannot be read, or folders nested deeper
  /// than `FolderWatch::kMaxDepth`. The numbers are then those of what was seen.
  bool complete = true;
};

/// Measures a folder that somebody else is writing into. It holds the folder itself, not its name: moving it
/// away or putting a link in its place changes nothing. Links are never followed.
class FolderWatch {
 public:
  static constexpr std::int64_t kMaxEntries = 100'000;
  static constexpr int kMaxDepth = 64;

  /// Throws std::system_error if `folder` is not a folder that can be opened. A link to one is followed.
  explicit FolderWatch(const std::filesystem::path& folder, std::int64_t max_entries = kMaxEntries);

  /// Counts anew. Files that disappear meanwhile are left out.
  FolderSize measure() const;

 private:
  FileDescriptor folder_;
  std::int64_t max_entries_;
};

}  // namespace plumb

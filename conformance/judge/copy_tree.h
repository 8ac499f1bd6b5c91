#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace plumb {

/// What of a submission is not copied: pictures, which are stale, and links and special files, by name.
struct LeftOut {
  int pictures = 0;
  std::vector<std::string> not_ordinary;
};

enum class Pictures { copy, leave_out };

/// Copies the regular files and folders below `from` over those in `to`, with permissions that let us read, change and
/// remove the copy. Throws InputError past 1 GiB (a sparse file counts in full), 100,000 files and folders, or 64
/// levels; a file system's error is filesystem_error.
LeftOut copy_tree(const std::filesystem::path& from, const std::filesystem::path& to, Pictures pictures);

/// Whether the file's name ends as those of pictures do.
bool is_picture(const std::filesystem::path& file);

}  // namespace plumb

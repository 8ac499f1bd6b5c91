#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace plumb {

/// What became of an output that a submission was to leave behind.
enum class HarvestStatus {
  copied,       ///< It is at the destination.
  missing,      ///< There is no such file, or it may not be read.
  not_regular,  ///< A folder, pipe, socket or device stands there.
  link,         ///< A link: symbolic (anywhere on the way) or hard, or the way leads out of the folder.
  too_large,    ///< It has more bytes than allowed.
};

/// The name of a status as it is written above.
const char* to_string(HarvestStatus status);

/// The end of one harvest.
struct HarvestResult {
  HarvestStatus status = HarvestStatus::missing;
  std::string sentence;    ///< For people, without a full stop: `out.png is a symbolic link`.
  std::int64_t bytes = 0;  ///< How many were copied.
};

/// Copies the file `relative_path` below `folder` to `destination`, replacing what is there. To be called when
/// no process of the submission is left. The way is followed inside the folder only and through no link (the
/// folder itself may not be one either: `link`), the file is opened once without waiting, checked and copied by
/// that descriptor, and never more than `max_bytes` are read into the destination, however it grows. Unless the
/// status is `copied`, the destination is as it was.
///
/// The sentence holds `relative_path` with control characters replaced. Throws std::invalid_argument if
/// `relative_path` is empty or `max_bytes` negative, and std::system_error where the destination cannot be
/// written, the file cannot be read through, or the kernel has no openat2 (before 5.6).
HarvestResult harvest(const std::filesystem::path& folder, const std::filesystem::path& relative_path,
                      std::int64_t max_bytes, const std::filesystem::path& destination);

}  // namespace plumb

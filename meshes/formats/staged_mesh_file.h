#pragma once

#include <filesystem>
#include <fstream>
#include <ostream>
#include <vector>

namespace plumb {

/// A mesh file that is there whole or not at all: the bytes go to a temporary file beside it, which `commit` renames
/// over it. Without `commit` the temporary file goes when this does.
class StagedMeshFile {
 public:
  /// Throws InputError if no file can be made there.
  explicit StagedMeshFile(const std::filesystem::path& file);
  ~StagedMeshFile();
  StagedMeshFile(const StagedMeshFile&) = delete;
  StagedMeshFile& operator=(const StagedMeshFile&) = delete;

  std::ostream& stream() { return out_; }
  /// Throws InputError if not all bytes could be written, or the name belongs to a folder.
  void commit();

 private:
  [[noreturn]] void fail();

  std::filesystem::path file_, temporary_;
  std::vector<char> buffer_;
  std::ofstream out_;
};

}  // namespace plumb

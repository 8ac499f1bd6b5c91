#include "meshes/formats/staged_mesh_file.h"

#include <unistd.h>

#include <atomic>
#include <string>
#include <system_error>

#include "renderer/math/input_error.h"

namespace plumb {
namespace {

/// A name that no other thread and no other process writes to.
std::filesystem::path temporary_beside(const std::filesystem::path& file) {
  static std::atomic<unsigned> serial = 0;
  std::filesystem::path temporary = file;
  std::string ending = ".";
  ending.append(std::to_string(getpid())).append("-").append(std::to_string(serial++)).append(".tmp");
  return temporary += ending;
}

}  // namespace

StagedMeshFile::StagedMeshFile(const std::filesystem::path& file)
    : file_(file), temporary_(temporary_beside(file)), buffer_(std::size_t{1} << 18) {
  out_.rdbuf()->pubsetbuf(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  out_.open(temporary_, std::ios::binary);
  if (!out_) fail();
}

StagedMeshFile::~StagedMeshFile() {
  std::error_code ignored;
  if (!temporary_.empty()) std::filesystem::remove(temporary_, ignored);
}

void StagedMeshFile::commit() {
  out_.close();
  std::error_code error;
  if (out_) std::filesystem::rename(temporary_, file_, error);
  if (!out_ || error) fail();
  temporary_.clear();
}

void StagedMeshFile::fail() {
  throw InputError({file_.string()}, "the mesh cannot be written; expected a place for a file in a folder that exists");
}

}  // namespace plumb

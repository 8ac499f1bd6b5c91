#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include "meshes/read_mesh.h"
#include "renderer/math/input_error.h"

namespace plumb {

/// A folder that no other process uses; removed when the program ends.
class TestFolder {
 public:
  TestFolder() : path_(std::filesystem::path(::testing::TempDir()) / ("plumb-meshes-" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~TestFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The path of a file in such a folder.
inline std::filesystem::path test_file(const std::string& name) {
  static const TestFolder folder;
  return folder.path() / name;
}

/// Writes `content` into such a file and returns its path.
inline std::filesystem::path write_test_file(const std::string& name, const std::string& content) {
  const auto file = test_file(name);
  std::ofstream(file, std::ios::binary).write(content.data(), static_cast<std::streamsize>(content.size()));
  return file;
}

/// The mesh in a file with this name and content.
inline TriangleMesh read_text(const std::string& name, const std::string& content) {
  return read_mesh(write_test_file(name, content));
}

/// The text of the InputError for a file with this name and content, without the folder; empty if it is read.
inline std::string refusal(const std::string& name, const std::string& content) {
  const auto file = write_test_file(name, content);
  try {
    read_mesh(file);
  } catch (const InputError& error) {
    return std::string(error.what()).substr(file.parent_path().string().size() + 1);
  }
  return "";
}

/// The bytes of a number in the machine's order.
template <class Number>
std::string raw(Number number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

}  // namespace plumb

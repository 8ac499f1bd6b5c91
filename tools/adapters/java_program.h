#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace plumb {

/// A copy of examples/java-framework in a temporary folder, which a test may change, then compile together with the
/// adapter, and ask. Throws std::runtime_error, with what the compiler or the program said, if anything goes wrong.
class JavaProgram {
 public:
  JavaProgram();
  ~JavaProgram();
  JavaProgram(const JavaProgram&) = delete;
  JavaProgram& operator=(const JavaProgram&) = delete;

  /// Copies the files of a folder over those of the framework.
  void overlay(const std::filesystem::path& folder);
  /// Replaces a text in one file, `ray/Scene.java` say, wherever it occurs there; throws if it does not.
  void replace(const std::string& file, const std::string& what, const std::string& by);
  /// The same in all files together.
  void replace_everywhere(const std::string& what, const std::string& by);
  /// Writes a file beside the framework's.
  void write(const std::string& file, const std::string& text) const;
  void compile() const;

  /// Answers in the order of the questions, which are numbered here, and before them the greeting. Everything the
  /// program prints that is no answer goes to log().
  std::vector<nlohmann::json> ask(std::vector<nlohmann::json> questions, const std::string& options = "");
  const std::string& log() const { return log_; }

  /// A file in the temporary folder.
  std::string path(const std::string& file) const { return (folder_ / file).string(); }

 private:
  std::vector<std::filesystem::path> sources() const;

  std::filesystem::path folder_;
  std::string log_;
};

}  // namespace plumb

#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace plumb {

/// Runs the built `plumb` in a folder of the test's own, and holds what it said.
class ProgramTest : public testing::Test {
 protected:
  ProgramTest() {
    std::string name = (std::filesystem::temp_directory_path() / "plumb-program-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder for the test");
    folder_ = std::filesystem::canonical(name);
  }
  ~ProgramTest() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  /// The exit status of a line for the shell; -1 if it ended otherwise.
  int shell(const std::string& line) {
    const std::string command =
        "cd '" + folder_.string() + "' && { " + line + "; } >said.txt 2>complained.txt </dev/null";
    const int status = std::system(command.c_str());
    said_ = content("said.txt");
    complained_ = content("complained.txt");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  int plumb(const std::string& arguments, const std::string& variables = "") {
    return shell(variables + " '" PLUMB_PROGRAM "' " + arguments);
  }

  std::string content(const std::string& file) const {
    std::ifstream stream(folder_ / file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  /// Of a result set as JSON: `verdict (cause)` by the case's id.
  static std::map<std::string, std::string> verdicts(const nlohmann::json& results) {
    std::map<std::string, std::string> found;
    for (const nlohmann::json& c : results.at("cases")) {
      const std::string cause = c.at("cause");
      found[c.at("id")] = std::string(c.at("verdict")) + (cause.empty() ? "" : " (" + cause + ")");
    }
    return found;
  }
  /// Of what was said, which `--json` made.
  std::map<std::string, std::string> said_verdicts() const { return verdicts(nlohmann::json::parse(said_)); }

  std::filesystem::path folder_;
  std::string said_, complained_;
};

}  // namespace plumb

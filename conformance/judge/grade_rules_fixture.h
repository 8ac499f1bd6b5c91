#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "conformance/judge/grade.h"
#include "conformance/sandbox/run_process.h"
#include "renderer/image/write_image.h"
#include "renderer/math/input_error.h"

namespace plumb {

namespace fs = std::filesystem;

/// A submission whose render.sh gets scene and output, and suites of several cases over the scenes a.txt, b.txt and so
/// on.
class GradeRulesTest : public testing::Test {
 protected:
  GradeRulesTest() {
    std::string name = (fs::temp_directory_path() / "plumb-rules-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder for the test");
    folder_ = fs::canonical(name);
    fs::create_directory(folder_ / "sub");
    constexpr std::array<std::uint8_t, 6> kLevels{10, 20, 30, 40, 50, 60};
    write_png(kLevels, 2, 1, folder_ / "ref.png");
    fs::copy_file(folder_ / "ref.png", folder_ / "sub/answer");
    for (const char* scene : {"a.txt", "b.txt", "c.txt", "d.txt"}) write(scene, scene);
    // A scene that begins with `bad` gets no picture.
    write("sub/render.sh", "grep -q bad \"$1\" || cp answer \"$2\"\n");
    interrupt_flag() = false;
  }
  ~GradeRulesTest() override {
    interrupt_flag() = false;
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  static std::string suite(
      const std::string& keys = "",
      const std::string& runner = "render = [\"/bin/sh\", \"render.sh\", \"{scene}\", \"{output}\"]") {
    return "[suite]\nid = \"s\"\nschema = 1\n" + keys + "\n" + (runner.empty() ? "" : "[runner]\n" + runner + "\n");
  }
  static std::string a_case(const std::string& id, const std::string& keys = "") {
    return "[[case]]\nid = \"" + id + "\"\nscene = \"" + id + ".txt\"\nreference = \"ref.png\"\npoints = 10\n" + keys +
           "\n";
  }
  GradeRequest request(const std::string& text) const {
    write("suite.toml", text);
    GradeRequest request;
    request.submission = folder_ / "sub";
    request.suite = read_suite(folder_ / "suite.toml");
    request.out = folder_ / "out";
    return request;
  }
  ResultSet grade_by(const std::string& text) const { return grade(request(text)); }

  fs::path folder_;
};

inline std::vector<std::string> outcomes(const ResultSet& results) {
  std::vector<std::string> texts;
  for (const CaseResult& c : results.cases)
    texts.push_back(c.id + ": " + std::string(to_string(c.check.verdict)) +
                    (c.check.cause.empty() ? "" : " (" + c.check.cause + ")"));
  return texts;
}

inline std::string first_summary(const ResultSet& results) { return results.cases.at(0).check.summary; }

}  // namespace plumb

// `plumb grade`, run as a program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <thread>

#include "renderer/image/write_image.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

std::string content(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class GradeCommandTest : public testing::Test {
 protected:
  GradeCommandTest() {
    std::string name = (fs::temp_directory_path() / "plumb-grade-command-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder for the test");
    folder_ = fs::canonical(name);
    fs::create_directories(folder_ / "sub");
    constexpr std::array<std::uint8_t, 3> kLevels{10, 20, 30};
    write_png(kLevels, 1, 1, folder_ / "ref.png");
    fs::copy_file(folder_ / "ref.png", folder_ / "sub/answer");
    write("sub/render.sh", "grep -q slow \"$1\" && sleep 100\ngrep -q bad \"$1\" || cp answer \"$2\"\n");
    write("good.txt", "good");
    write("bad.txt", "bad");
    write("slow.txt", "slow");
    write("right.toml", kHead + a_case("good"));
    write("wrong.toml", kHead + a_case("good") + a_case("bad"));
    write("slow.toml",
          kHead + a_case("good") + a_case("slow", "cpu_seconds = 60\n") + a_case("bad", "cpu_seconds = 90\n"));
  }
  ~GradeCommandTest() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  static std::string a_case(const std::string& id, const std::string& keys = "") {
    return "[[case]]\nid = \"" + id + "\"\nscene = \"" + id + ".txt\"\nreference = \"ref.png\"\n" + keys;
  }
  int plumb(const std::string& arguments) {
    const std::string command =
        "cd '" + folder_.string() + "' && '" PLUMB_PROGRAM "' " + arguments + " >said.txt 2>complained.txt";
    const int status = std::system(command.c_str());
    said_ = content(folder_ / "said.txt");
    complained_ = content(folder_ / "complained.txt");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  nlohmann::json results(const std::string& out) const {
    return nlohmann::json::parse(content(folder_ / out / "results.json"));
  }

  static inline const std::string kHead =
      "[suite]\nid = \"s\"\nschema = 1\n[runner]\nrender = [\"/bin/sh\", \"render.sh\", \"{scene}\", \"{output}\"]\n";
  fs::path folder_;
  std::string said_, complained_;
};

TEST_F(GradeCommandTest, TheExitStatusSaysWhetherEveryCaseIsRight) {
  EXPECT_EQ(plumb("grade sub --suite right.toml --out out"), 0) << complained_;
  EXPECT_THAT(said_, HasSubstr("not isolated: run only programs you trust"));
  EXPECT_THAT(said_, HasSubstr("Suite s: 1 case, at most 210 s."));
  EXPECT_THAT(said_, HasSubstr("good  pass"));
  EXPECT_THAT(said_, HasSubstr("Results, pictures and logs: out"));
  EXPECT_THAT(said_, Not(HasSubstr("\x1b["))) << "no colours in a file";
  EXPECT_EQ(plumb("grade sub --suite wrong.toml --out out"), 1) << complained_;
  EXPECT_EQ(results("out")["totals"]["points"], 1);
  EXPECT_EQ(plumb("grade sub --suite wrong.toml --out out --filter 'g*'"), 0) << complained_;
  EXPECT_EQ(results("out")["cases"].size(), 1U);
}

TEST_F(GradeCommandTest, WithoutOutTheResultsBearTheSubmissionsName) {
  EXPECT_EQ(plumb("grade sub/ --suite right.toml"), 0) << complained_;
  EXPECT_EQ(results("plumb-results/sub")["submission"], "sub");
}

TEST_F(GradeCommandTest, WhatCannotBeGradedIsAUsageError) {
  write("broken.toml", "[suite]\nid = \n");
  write("lost.toml", kHead + a_case("gone"));
  const struct {
    const char* arguments;
    const char* complaint;
  } table[] = {
      {"grade", "submission"},
      {"grade sub", "--suite"},
      {"grade sub --suite gone.toml", "gone.toml: cannot open the file"},
      {"grade sub --suite broken.toml", "broken.toml:2:"},
      {"grade sub --suite lost.toml", "lost.toml:8:9: 'scene' of [[case]] names a file that does not exist"},
      {"grade gone --suite right.toml", "the submission is no folder"},
      {"grade ref.png --suite right.toml", "the submission is no folder"},
      {"grade sub --suite right.toml --out sub/out", "would lie inside the submission"},
      {"grade sub --suite right.toml --out .", "the submission lies inside"},
      {"grade sub --suite right.toml --filter none", "no case of the suite matches 'none'"},
      {"grade sub --suite right.toml --shout", ""},
      {"grade sub more --suite right.toml", ""},
      {"graid sub", ""},
      {"", ""},
  };
  for (const auto& row : table) {
    EXPECT_EQ(plumb(row.arguments), 2) << row.arguments << "\n" << said_;
    EXPECT_THAT(complained_ + said_, HasSubstr(row.complaint)) << row.arguments;
  }
  EXPECT_FALSE(fs::exists(folder_ / "out"));
  EXPECT_FALSE(fs::exists(folder_ / "plumb-results/sub"));
  EXPECT_FALSE(fs::exists(folder_ / "plumb-results/sub.partial"));
}

TEST_F(GradeCommandTest, AnInterruptStillWritesTheResults) {
  const std::string suite = (folder_ / "slow.toml").string();
  const std::string submission = (folder_ / "sub").string();
  const std::string out = (folder_ / "out").string();
  const pid_t pid = ::fork();
  ASSERT_GE(pid, 0);
  if (pid == 0) {
    std::freopen((folder_ / "said.txt").c_str(), "w", stdout);
    ::execl(PLUMB_PROGRAM, "plumb", "grade", submission.c_str(), "--suite", suite.c_str(), "--out", out.c_str(),
            nullptr);
    ::_exit(99);
  }
  // The first case is written before the slow one starts, which sleeps far longer than this test waits.
  const auto first_is_written = [&] {
    for (const auto& entry : fs::directory_iterator(folder_))
      if (entry.path().filename().string().starts_with("out.partial-") &&
          fs::exists(entry.path() / "cases/good/case.json"))
        return true;
    return false;
  };
  for (int i = 0; i < 3000 && !first_is_written(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  ASSERT_EQ(::kill(pid, SIGINT), 0);
  int status = 0;
  ASSERT_EQ(::waitpid(pid, &status, 0), pid);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  const nlohmann::json json = results("out");
  ASSERT_EQ(json["cases"].size(), 3U);
  EXPECT_EQ(json["cases"][0]["verdict"], "pass");
  EXPECT_EQ(json["cases"][1]["cause"], "interrupted");
  EXPECT_EQ(json["cases"][2]["cause"], "interrupted");
  EXPECT_EQ(json["totals"]["pending_points"], 2);
  EXPECT_THAT(content(folder_ / "said.txt"), HasSubstr("2 points wait for a person"));
}

TEST_F(GradeCommandTest, OurOwnFaultIsExitStatus3) {
  // The reference vanishes between the reading of the suite and the judging.
  write("sub/render.sh", "rm -f '" + (folder_ / "lost.png").string() + "'; cp answer \"$2\"\n");
  fs::copy_file(folder_ / "ref.png", folder_ / "lost.png");
  write("lost.toml", kHead + "[[case]]\nid = \"a\"\nscene = \"good.txt\"\nreference = \"lost.png\"\n" + a_case("good"));
  EXPECT_EQ(plumb("grade sub --suite lost.toml --out out"), 3) << said_ << complained_;
  EXPECT_EQ(results("out")["cases"][0]["verdict"], "internal_error");
  EXPECT_EQ(results("out")["cases"][1]["verdict"], "pass");
  EXPECT_EQ(results("out")["totals"]["pending_points"], 1);
}

TEST_F(GradeCommandTest, TheResultsDoNotDependOnWhereTheProgramIsCalledFrom) {
  EXPECT_EQ(plumb("grade sub --suite wrong.toml --out here"), 1);
  fs::create_directory(folder_ / "below");
  fs::create_directory(folder_ / "below/temporary");
  const std::string command = "cd '" + (folder_ / "below").string() +
                              "' && TMPDIR=\"$PWD/temporary\" '" PLUMB_PROGRAM
                              "' grade ../sub/ --suite ../wrong.toml --out there/ >/dev/null 2>&1";
  const int status = std::system(command.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 1);
  EXPECT_EQ(content(folder_ / "here/results.json"), content(folder_ / "below/there/results.json"));
  for (const char* id : {"good", "bad"})
    EXPECT_EQ(content(folder_ / "here/cases" / id / "case.json"),
              content(folder_ / "below/there/cases" / id / "case.json"));
  EXPECT_THAT(content(folder_ / "here/results.json"), HasSubstr("\"submission\": \"sub\""));
}

}  // namespace
}  // namespace plumb

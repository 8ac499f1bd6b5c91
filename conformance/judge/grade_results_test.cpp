#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "conformance/judge/grade.h"
#include "conformance/judge/suite_hash.h"
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

/// What grading leaves behind for a submission with a case of each kind of end.
class GradeResultsTest : public testing::Test {
 protected:
  GradeResultsTest() : home_(fs::current_path()) {
    std::string name = (fs::temp_directory_path() / "plumb-results-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder for the test");
    folder_ = fs::canonical(name);
    fs::create_directories(folder_ / "sub");
    constexpr std::array<std::uint8_t, 6> kLevels{10, 20, 30, 40, 50, 60};
    constexpr std::array<std::uint8_t, 6> kOther{10, 20, 30, 40, 50, 99};
    write_png(kLevels, 2, 1, folder_ / "ref.png");
    fs::copy_file(folder_ / "ref.png", folder_ / "sub/answer");
    write_png(kOther, 2, 1, folder_ / "other.png");
    fs::rename(folder_ / "other.png", folder_ / "sub/other");
    std::string suite =
        "[suite]\nid = \"s\"\nschema = 1\ndialect = \"d\"\n[[variant]]\nid = \"v\"\n[runner]\nbuild = "
        "[[\"true\"]]\nrender "
        "= [\"/bin/sh\", \"render.sh\", \"{scene_name}\", \"{output}\"]\n";
    std::string script = "pwd; date +%N; cat answer >/dev/null\ncase $1 in\n";
    for (const auto& [id, command] : commands_) {
      write(id + ".txt", id);
      suite += "[[case]]\nid = \"" + id + "\"\nscene = \"" + id +
               ".txt\"\nreference = \"ref.png\"\nrequirement = \"r\"\nwall_seconds = 1.5\n" +
               (id == "skipped" ? "requires = [\"late\"]\n" : "");
      script += id + ".txt) " + command + " ;;\n";
    }
    write("suite.toml", suite);
    write("sub/render.sh", script + "esac\n");
  }
  ~GradeResultsTest() override {
    fs::current_path(home_);
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  ResultSet grade_to(const fs::path& out) const {
    GradeRequest request;
    request.submission = folder_ / "sub";
    request.suite = read_suite(folder_ / "suite.toml");
    request.out = out;
    request.plumb_version = "1.2.3";
    return grade(request);
  }
  nlohmann::json read_json(const fs::path& file) const { return nlohmann::json::parse(content(file)); }

  const std::map<std::string, std::string> commands_{{"crash", "kill -SEGV $$"},
                                                     {"cut", "head -c 60 answer > \"$2\""},
                                                     {"late", "sleep 100"},
                                                     {"link", "ln -s /etc/hostname \"$2\""},
                                                     {"none", "exit 9"},
                                                     {"other", "cp other \"$2\""},
                                                     {"right", "cp answer \"$2\""},
                                                     {"skipped", "true"},
                                                     {"status", "cp answer \"$2\"; exit 1"},
                                                     {"text", "echo no picture > \"$2\""}};
  fs::path home_;
  fs::path folder_;
};

TEST_F(GradeResultsTest, AreIdenticalFromAnotherPlaceAndAnotherTemporaryFolder) {
  grade_to(folder_ / "first");
  const char* const before = std::getenv("TMPDIR");
  const std::string old = before ? before : "";
  fs::create_directories(folder_ / "temporary/files");
  ::setenv("TMPDIR", (folder_ / "temporary/files").c_str(), 1);
  fs::current_path(folder_ / "temporary");
  grade_to("second");
  before ? ::setenv("TMPDIR", old.c_str(), 1) : ::unsetenv("TMPDIR");
  const fs::path second = folder_ / "temporary/second";
  EXPECT_EQ(content(folder_ / "first/results.json"), content(second / "results.json"));
  std::size_t compared = 0;
  for (const auto& [id, command] : commands_) {
    EXPECT_EQ(content(folder_ / "first/cases" / id / "case.json"), content(second / "cases" / id / "case.json"));
    compared += fs::exists(second / "cases" / id / "case.json") ? 1U : 0U;
  }
  EXPECT_EQ(compared, commands_.size());
  EXPECT_TRUE(fs::is_empty(folder_ / "temporary/files")) << "the working folders are gone";
}

TEST_F(GradeResultsTest, HoldNoPlaceNoTimeAndNoHost) {
  grade_to(folder_ / "out");
  std::array<char, 256> host{};
  ASSERT_EQ(::gethostname(host.data(), host.size() - 1), 0);
  std::string all = content(folder_ / "out/results.json");
  for (const auto& [id, command] : commands_) all += content(folder_ / "out/cases" / id / "case.json");
  for (const std::string& word :
       {folder_.string(), fs::temp_directory_path().string() + "/", std::string("/tmp"), std::string("/work"),
        std::string("/home"), std::string(host.data()), std::string("cpu_seconds"), std::string("plumb-")})
    EXPECT_THAT(all, Not(HasSubstr(word)));
}

TEST_F(GradeResultsTest, SayWhatWasFound) {
  const ResultSet results = grade_to(folder_ / "out");
  const nlohmann::json json = read_json(folder_ / "out/results.json");
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["suite"]["id"], "s");
  EXPECT_EQ(json["suite"]["hash"], results.suite_hash);
  EXPECT_EQ(json["suite"]["dialect"], "d");
  EXPECT_EQ(json["submission"], "sub");
  EXPECT_EQ(json["versions"]["plumb"], "1.2.3");
  EXPECT_EQ(json["totals"]["points"], 2);
  EXPECT_EQ(json["totals"]["max_points"], 10);
  ASSERT_EQ(json["cases"].size(), commands_.size());
  const std::map<std::string, std::string> expected{
      {"crash", "crash/signal"},   {"cut", "fail/bad_picture"},         {"late", "timeout/wall_time"},
      {"link", "security/link"},   {"none", "fail/no_picture"},         {"other", "fail/different"},
      {"right", "pass/"},          {"skipped", "skipped/prerequisite"}, {"status", "quality_warning/exit_status"},
      {"text", "fail/bad_picture"}};
  for (const nlohmann::json& c : json["cases"])
    EXPECT_EQ(c["verdict"].get<std::string>() + "/" + c["cause"].get<std::string>(), expected.at(c["id"])) << c["id"];
}

TEST_F(GradeResultsTest, ACaseHoldsItsEvidence) {
  grade_to(folder_ / "out");
  const nlohmann::json json = read_json(folder_ / "out/cases/other/case.json");
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["margin"], -38);
  EXPECT_EQ(json["evidence"]["pixels"], 2);
  EXPECT_EQ(json["evidence"]["pixels_past_tolerance"], 1);
  EXPECT_EQ(json["evidence"]["max_difference"], 39);
  EXPECT_EQ(json["evidence"]["max_x"], 1);
  EXPECT_EQ(json["evidence"]["max_y"], 0);
  EXPECT_EQ(json["evidence"]["expected"], "40 50 60");
  EXPECT_EQ(json["evidence"]["found"], "40 50 99");
  EXPECT_EQ(json["hashes"]["inputs"]["other.txt"], file_hash(folder_ / "other.txt"));
  EXPECT_EQ(json["hashes"]["reference"], file_hash(folder_ / "ref.png"));
  EXPECT_EQ(json["hashes"]["picture"], file_hash(folder_ / "sub/other"));
  EXPECT_EQ(json["versions"]["plumb"], "1.2.3");
  EXPECT_EQ(json["repeat"], "plumb grade sub --suite suite.toml --filter other");
  EXPECT_TRUE(json["margin"].is_number());
  EXPECT_TRUE(read_json(folder_ / "out/cases/none/case.json")["margin"].is_null());
}

TEST_F(GradeResultsTest, MeasurementsStandInUsageAlone) {
  grade_to(folder_ / "out");
  for (const auto& [id, command] : commands_) {
    const nlohmann::json usage = read_json(folder_ / "out/cases" / id / "usage.json");
    EXPECT_TRUE(usage["host"].contains("name"));
    EXPECT_EQ(usage.contains("wall_seconds"), id != "skipped") << id;
  }
  const nlohmann::json late = read_json(folder_ / "out/cases/late/usage.json");
  EXPECT_EQ(late["stopped"], "wall_limit");
  EXPECT_GE(late["wall_seconds"], 1.5);
  EXPECT_LT(late["margin"], 0);
  EXPECT_FALSE(late["active_limits"].empty());
  EXPECT_EQ(read_json(folder_ / "out/cases/crash/usage.json")["signal"], 11);
}

TEST_F(GradeResultsTest, TakeThePlaceOfAnEarlierSetWhole) {
  grade_to(folder_ / "out/");
  write("out/cases/stale", "");
  grade_to(folder_ / "out");
  EXPECT_FALSE(fs::exists(folder_ / "out/cases/stale"));
  EXPECT_TRUE(fs::exists(folder_ / "out/results.json"));
  EXPECT_FALSE(fs::exists(folder_ / "out.partial"));
  EXPECT_FALSE(fs::exists(folder_ / "out.older"));
}

TEST_F(GradeResultsTest, ASubmissionWithAStrangeNameIsStillJson) {
  const fs::path strange = folder_ / "a b\"\n\xff\x1b[31m";
  fs::rename(folder_ / "sub", strange);
  GradeRequest request;
  request.submission = strange;
  request.suite = read_suite(folder_ / "suite.toml");
  request.out = folder_ / "out";
  request.filter = "right";
  EXPECT_EQ(grade(request).cases.at(0).check.verdict, Verdict::pass);
  EXPECT_EQ(read_json(folder_ / "out/results.json")["submission"], "a b\"\n\xef\xbf\xbd\x1b[31m");
}

TEST_F(GradeResultsTest, NothingOfTheReferencesIsReachableByName) {
  write("sub/render.sh",
        "find -L . .. ../.. ../../.. -maxdepth 6 2>/dev/null; env; for f in $(find .. -type f); do cat \"$f\"; done; "
        "echo end of list\n");
  GradeRequest request;
  request.submission = folder_ / "sub";
  request.suite = read_suite(folder_ / "suite.toml");
  request.out = folder_ / "out";
  request.filter = "right";
  grade(request);
  const std::string log = content(folder_ / "out/cases/right/log.txt");
  ASSERT_THAT(log, HasSubstr("end of list"));
  ASSERT_THAT(log, HasSubstr("./right.txt")) << "the list holds what is there";
  for (const char* hidden : {"ref.png", "reference", "suite.toml", "results", "crash.txt"})
    EXPECT_THAT(log, Not(HasSubstr(hidden)));
  EXPECT_THAT(log, Not(HasSubstr(folder_.string())));
}

}  // namespace
}  // namespace plumb

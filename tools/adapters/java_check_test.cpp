// `plumb check` and `plumb grade` of the Java framework by the suite of the repository, and of its planted faults: each
// is found, and by its name.
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
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

class JavaCheckTest : public testing::Test {
 protected:
  JavaCheckTest() {
    std::string name = (fs::temp_directory_path() / "plumb-java-check-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder for the test");
    folder_ = fs::canonical(name);
    lay(kExamples + "/java-framework");
  }
  ~JavaCheckTest() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  /// Puts a folder's files into the submission, over what is there.
  void lay(const fs::path& from) const {
    fs::copy(from, folder_ / "sub", fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  }
  int plumb(const std::string& arguments) {
    const std::string command = "cd '" + folder_.string() + "' && '" PLUMB_PROGRAM "' " + arguments +
                                " --suite '" PLUMB_SOURCE_DIR "/suites/java-framework.toml' >said.txt 2>&1 </dev/null";
    const int status = std::system(command.c_str());
    said_ = content("said.txt");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string content(const fs::path& file) const {
    std::ifstream stream(folder_ / file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  /// `verdict (cause)` of each check or case in a result set.
  std::map<std::string, std::string> results() const {
    std::map<std::string, std::string> found;
    const nlohmann::json set = nlohmann::json::parse(content("out/results.json"));
    for (const nlohmann::json& one : set.at("cases")) {
      const std::string cause = one.at("cause");
      found[one.at("id")] = std::string(one.at("verdict")) + (cause.empty() ? "" : " (" + cause + ")");
    }
    return found;
  }
  /// The same of these checks, few questions of each, for the framework with the file of a fault.
  std::map<std::string, std::string> results_of(const std::string& fault, const std::string& filter) {
    lay(kExamples + "/java-framework-faulty/" + fault);
    EXPECT_EQ(plumb("check sub --out out --intensity 0.05 --filter " + filter), 1) << said_;
    return results();
  }
  std::string advice(const std::string& check) const {
    return nlohmann::json::parse(content("out/cases/" + check + "/case.json")).at("advice");
  }

  static inline const std::string kExamples = PLUMB_SOURCE_DIR "/examples";
  fs::path folder_;
  std::string said_;
};

TEST_F(JavaCheckTest, TheFrameworkEarnsEveryPointOfTheSuite) {
  EXPECT_EQ(plumb("grade sub --out out"), 0) << said_;
  EXPECT_THAT(results(), ElementsAre(Pair("boxes", "pass"), Pair("groups", "pass"), Pair("hierarchy", "pass"),
                                     Pair("intersections", "pass"), Pair("matrices", "pass")))
      << said_;
  EXPECT_EQ(nlohmann::json::parse(content("out/results.json"))["totals"]["points"], 100);
}

TEST_F(JavaCheckTest, TheFrameworkPassesWhereItsFaultsAreFound) {
  EXPECT_EQ(plumb("check sub --out out --intensity 0.05 --filter A1,M2,matrices,bounds"), 0) << said_;
  EXPECT_THAT(results(),
              ElementsAre(Pair("A1", "pass"), Pair("M2", "pass"), Pair("bounds", "pass"), Pair("matrices", "pass")));
}

TEST_F(JavaCheckTest, RotationsAboutZFirst) {
  EXPECT_THAT(results_of("rotation-order", "matrices"), ElementsAre(Pair("matrices", "fail (rotation_order)")));
  EXPECT_THAT(advice("matrices"),
              AllOf(HasSubstr("rotations are applied about z first"), HasSubstr("plumb oracle matrix")));
}

TEST_F(JavaCheckTest, ABoxThatMissesACorner) {
  EXPECT_THAT(results_of("box-misses-corner", "A1"), ElementsAre(Pair("A1", "fail (not_contained)")));
  EXPECT_THAT(advice("A1"), HasSubstr("plumb oracle bounds --box")) << "the box is named that does";
}

TEST_F(JavaCheckTest, ABoxThatIsNotTransformed) {
  EXPECT_THAT(results_of("box-not-transformed", "bounds"), ElementsAre(Pair("bounds", "fail (not_contained)")));
  EXPECT_THAT(advice("bounds"), HasSubstr("plumb oracle bounds --sphere"));
}

TEST_F(JavaCheckTest, NormalsByTheMatrix) {
  EXPECT_THAT(results_of("normal-by-matrix", "M2"), ElementsAre(Pair("M2", "fail (normal)")));
  EXPECT_THAT(advice("M2"), HasSubstr("inverse transpose"));
}

TEST_F(JavaCheckTest, DirectionsMadeUnit) {
  EXPECT_THAT(results_of("t-normalised", "M2"), ElementsAre(Pair("M2", "fail (t_normalised)")));
  EXPECT_THAT(advice("M2"), HasSubstr("the direction was made unit"));
}

}  // namespace
}  // namespace plumb

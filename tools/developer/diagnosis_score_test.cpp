#include "tools/developer/diagnosis_score.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>

#include "conformance/diagnosis/synthetic_cases_for_tests.h"
#include "renderer/image/write_image.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

class Scored : public ::testing::Test {
 protected:
  void SetUp() override {
    SyntheticCases cases(no_change);
    cases.add_mistake("corner", corner_);
    cases.add_mistake("band", band_);
    for (const DiagnosisCase& c : cases.cases) write_envelope(*c.envelope, folder_ / "built/envelopes" / c.id);
    std::ofstream(folder_ / "built/scene.txt") << "a scene";
    std::ofstream suite(folder_ / "built/suite.toml");
    suite << "[suite]\nid = \"s\"\nschema = 1\nfingerprints = \"fingerprints\"\n[runner]\nrender = [\"/bin/true\"]\n";
    for (const DiagnosisCase& c : cases.cases)
      suite << "[[case]]\nid = \"" << c.id << "\"\nscene = \"scene.txt\"\nenvelopes = [\"envelopes/" << c.id << "\"]\n";
    for (const Fingerprint& f : cases.fingerprints) write_fingerprint(f, folder_ / "built/fingerprints" / f.id);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void add(const std::string& label, const std::string& expected, const Change& change) const {
    const fs::path program = folder_ / "wrong" / label;
    fs::create_directories(program);
    std::ofstream(program / "expected") << expected;
    for (const std::string id : {"a", "b", "c", "d"})
      write_png(test_picture(id, change), kTestWidth, kTestHeight, program / (id + ".png"));
  }
  DiagnosisScore score() const {
    return score_diagnosis(read_knowledge(folder_ / "built"), read_planted_pictures(folder_ / "wrong"));
  }

  const Change corner_ = patch("a", 0, 0, 20, 20, -40), band_ = patch("b", 0, 10, 64, 16, 30);
  const fs::path folder_ = fs::temp_directory_path() / ("plumb-score-" + std::to_string(::getpid()));
};

TEST_F(Scored, CountsWhatIsRightAndWhatIsNot) {
  add("corner", "corner other-name\n", corner_);
  add("mislabelled", "corner\n", band_);
  add("unheard-of", "\n", patch("c", 20, 20, 40, 30, 60));
  add("corner+band", "corner\nband\n", sum(corner_, band_));
  add("right", "", no_change);
  const DiagnosisScore result = score();
  EXPECT_EQ(result.outcomes.size(), 5u);
  EXPECT_EQ(result.first.tries, 2);
  EXPECT_EQ(result.first.hits, 1);
  EXPECT_EQ(result.three.hits, 1);
  EXPECT_EQ(result.confidently_wrong.tries, 4);
  EXPECT_EQ(result.confidently_wrong.hits, 1);
  EXPECT_EQ(result.unknown_kept_open.tries, 1);
  EXPECT_EQ(result.unknown_kept_open.hits, 1);
  EXPECT_EQ(result.both_named.tries, 1);
  EXPECT_EQ(result.both_named.hits, 1);
  EXPECT_EQ(result.false_alarms.tries, 1);
  EXPECT_EQ(result.false_alarms.hits, 0);
}

TEST_F(Scored, APairCountsOnlyWhereBothShow) {
  add("corner", "corner\n", corner_);
  add("corner+band", "corner\nband\n", corner_);
  EXPECT_EQ(score().both_named.tries, 0);
}

TEST_F(Scored, FoldersMustBeThere) {
  EXPECT_THROW(read_knowledge(folder_ / "nothing"), InputError);
  fs::create_directories(folder_ / "wrong" / "unlabelled");
  EXPECT_THROW(read_planted_pictures(folder_ / "wrong"), InputError);
}

TEST(Rate, HasWilsonsInterval) {
  // [Wilson 1927], by hand for 9 of 10: (p + z^2/2n -+ z sqrt(pq/n + z^2/4n^2)) / (1 + z^2/n), z = 1.96.
  EXPECT_NEAR((Rate{9, 10}.low()), 0.596, 1e-3);
  EXPECT_NEAR((Rate{9, 10}.high()), 0.982, 1e-3);
  EXPECT_EQ((Rate{0, 0}.low()), 0);
  EXPECT_EQ((Rate{0, 0}.high()), 1);
}

}  // namespace
}  // namespace plumb

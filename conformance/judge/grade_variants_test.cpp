#include "conformance/envelopes/envelope.h"
#include "conformance/judge/grade_rules_fixture.h"

namespace plumb {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Cases with envelopes of two variants, `light` and `dark`, of a picture of 20 x 10 in one level; the submission
/// writes the pictures that lie ready in it as CASE.png.
class GradeVariantsTest : public GradeRulesTest {
 protected:
  static constexpr std::uint8_t kLight = 200, kDark = 90;

  void add_case(const std::string& id, bool differs, std::uint8_t drawn) {
    write(id + ".txt", id);
    add_envelope("e/" + id + "/light", kLight);
    add_envelope("e/" + id + "/dark", differs ? kDark : kLight);
    write_png(std::vector<std::uint8_t>(600, drawn), 20, 10, folder_ / "sub" / (id + ".hidden.png"));
    fs::rename(folder_ / "sub" / (id + ".hidden.png"), folder_ / "sub" / id);
    cases_ += "[[case]]\nid = \"" + id + "\"\nscene = \"" + id + ".txt\"\nenvelopes = [\"e/" + id + "/light\", \"e/" +
              id + "/dark\"]\npoints = 10\n";
  }
  void add_envelope(const std::string& name, std::uint8_t level) const {
    Envelope e;
    e.width = 20, e.height = 10;
    e.nominal = e.low = e.high = std::vector<std::uint8_t>(600, level);
    e.reasons.resize(200);
    write_envelope(e, folder_ / name);
  }
  ResultSet graded() const {
    write("sub/render.sh", "cp \"${1%.txt}\" \"$2\"\n");
    // The scene lies in the folder that it runs in, beside what the submission brought.
    return grade_by(suite() + "[[variant]]\nid = \"light\"\n[[variant]]\nid = \"dark\"\ncutoff = false\n" + cases_);
  }

  std::string cases_;
};

TEST_F(GradeVariantsTest, AnyVariantIsRightIfItIsKeptTo) {
  add_case("a", true, kDark);
  add_case("b", false, kLight);
  add_case("c", true, kDark);
  const ResultSet results = graded();
  EXPECT_THAT(outcomes(results), ElementsAre("a: pass", "b: pass", "c: pass"));
  EXPECT_EQ(results.variant, "dark");
  EXPECT_EQ(results.totals().points, 30);
  EXPECT_THAT(results.variants, ElementsAre("light", "dark"));
}

TEST_F(GradeVariantsTest, AMixtureLosesWhatFitsTheVariantOfFewerPoints) {
  add_case("a", true, kDark);
  add_case("b", true, kDark);
  add_case("c", true, kLight);
  const ResultSet results = graded();
  EXPECT_THAT(outcomes(results), ElementsAre("a: pass", "b: pass", "c: fail (different)"));
  EXPECT_THAT(results.cases[2].check.advice, HasSubstr("right by the variant 'light', the others by 'dark'"));
  EXPECT_EQ(results.totals().points, 20);
}

TEST_F(GradeVariantsTest, WrongByAllIsFailAndTheWrongPixelsAreShown) {
  add_case("a", true, 150);
  const ResultSet results = graded();
  EXPECT_THAT(outcomes(results), ElementsAre("a: fail (different)"));
  EXPECT_EQ(results.variant, "light") << "the first of those with equal points";
  EXPECT_EQ(results.totals().points, 0);
  EXPECT_TRUE(fs::exists(folder_ / "out/cases/a/difference.png"));
  EXPECT_FALSE(results.diagnosis.has_value()) << "the suite has no fingerprints";
}

TEST_F(GradeVariantsTest, ASuiteThatIsNotBuiltIsRefused) {
  write("a.txt", "a");
  EXPECT_THROW(grade_by(suite() + "[[case]]\nid = \"a\"\nscene = \"a.txt\"\n"), InputError);
}

}  // namespace
}  // namespace plumb

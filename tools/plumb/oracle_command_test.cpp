// `plumb oracle`, run as a program.
#include <array>

#include "tools/plumb/program_for_tests.h"

namespace plumb {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class OracleCommandTest : public ProgramTest {
 protected:
  /// The one triangle, in the plane z = 0, seen from above at x, y.
  std::string ray_at(const std::string& x_y) {
    EXPECT_EQ(plumb("oracle ray --triangle 0,0,0,4,0,0,0,4,0 --origin " + x_y + ",3 --direction 0,0,-2"), 0)
        << complained_;
    return said_;
  }
};

TEST_F(OracleCommandTest, ARayIsExplainedByItsDeterminants) {
  EXPECT_THAT(ray_at("1,1"), AllOf(HasSubstr("answer: hit at t = 0x1.8p+0 (1.5)"), HasSubstr("U, V and W"),
                                   HasSubstr("= 3/2 exactly"), HasSubstr("normal (0, 0, 1)")));
  EXPECT_THAT(ray_at("2,0"), AllOf(HasSubstr("answer: boundary"), HasSubstr("exactly zero"),
                                   HasSubstr("free: a program may report it or not")));
  EXPECT_THAT(ray_at("3,3"), AllOf(HasSubstr("answer: miss"), HasSubstr("U     -")));
}

TEST_F(OracleCommandTest, ARayAtEachSolid) {
  const std::string ray = " --origin 0,0,5 --direction 0,0,-1";
  const std::array<std::array<const char*, 2>, 5> answers{{{"--sphere 0,0,0,2", "answer: hit at t = 0x1.8p+1 (3)"},
                                                           {"--sphere 2,0,0,2", "answer: tangent at t = 0x1.4p+2 (5)"},
                                                           {"--box -1,-1,-1,1,1,1", "answer: hit at t = 0x1p+2 (4)"},
                                                           {"--cylinder 0,0,0,1,2", "answer: hit at t = 0x1p+2 (4)"},
                                                           {"--cone 0,0,0,4,1,2", "answer: hit at t = 0x1p+2 (4)"}}};
  for (const auto& [surface, answer] : answers) {
    EXPECT_EQ(plumb(std::string("oracle ray ") + surface + ray), 0) << complained_;
    EXPECT_THAT(said_, HasSubstr(answer)) << surface;
  }
  EXPECT_EQ(plumb("oracle ray --sphere 0,0,0,1 --matrix 1,0,0,0,0,1,0,0,0,0,2,0" + ray), 0);
  EXPECT_THAT(said_, HasSubstr("answer: hit at t = 0x1.8p+1 (3)"));
  EXPECT_EQ(plumb("oracle ray --sphere 0,0,0,1 --matrix 1,0,0,0,0,1,0,0,0,0,0,0" + ray), 0);
  EXPECT_THAT(said_, HasSubstr("answer: singular matrix"));
  EXPECT_EQ(plumb("oracle ray --sphere 0,0,0,1 --range 4,5" + ray), 0);
  EXPECT_THAT(said_, HasSubstr("exactly at t_min"));
}

TEST_F(OracleCommandTest, AClaimedBoxIsJudged) {
  EXPECT_EQ(plumb("oracle bounds --sphere 0,0,0,1 --claimed -1,-1,-1,1,1,1.5"), 0) << complained_;
  EXPECT_THAT(said_, AllOf(HasSubstr("contains the surface"), HasSubstr("min x: tight"),
                           HasSubstr("max z: 2251799813685248 doubles loose")));
  EXPECT_EQ(plumb("oracle bounds --sphere 0,0,0,1 --claimed -1,-1,-1,1,1,0x1.fffffffffffffp-1"), 1);
  EXPECT_THAT(said_, AllOf(HasSubstr("CUTS the surface"), HasSubstr("max z: 1 doubles too far inside")));
  EXPECT_EQ(plumb("oracle bounds --box 0,0,0,1,2,3 --matrix 0,-1,0,0,1,0,0,0,0,0,1,0"), 0);
  EXPECT_THAT(said_, HasSubstr("= -2"));
}

TEST_F(OracleCommandTest, TransformsAreMultipliedInTheOrderGiven) {
  EXPECT_EQ(plumb("oracle matrix --translate 1,2,3 --rotate 0,0,90 --scale 2,1,1"), 0) << complained_;
  EXPECT_THAT(said_,
              AllOf(HasSubstr("[0,1] = -1 "), HasSubstr("[1,0] = 2 "), HasSubstr("[0,3] = 1 "), HasSubstr("inverse")));
  EXPECT_EQ(plumb("oracle matrix --scale 2,1,1 --rotate 0,0,90"), 0);
  EXPECT_THAT(said_, HasSubstr("[0,1] = -2 "));
  EXPECT_EQ(plumb("oracle matrix --rotate 0,0,30"), 0);
  EXPECT_THAT(said_, AllOf(HasSubstr("[1,0] = 0.5 "), HasSubstr("or the next double")));
  EXPECT_EQ(plumb("oracle matrix --matrix 2,0,0,1,0,4,0,0,0,0,1,0"), 0);
  EXPECT_THAT(said_, AllOf(HasSubstr("inverse transpose"), HasSubstr("condition number 4")));
  EXPECT_EQ(plumb("oracle matrix --matrix 1,1,0,0,1,1,0,0,0,0,1,0"), 0);
  EXPECT_THAT(said_, HasSubstr("the determinant is exactly 0"));
}

TEST_F(OracleCommandTest, MistakesInTheCommandAreStatusTwo) {
  const std::array<std::array<const char*, 2>, 8> mistakes{
      {{"oracle", "subcommand"},
       {"oracle ray --origin 0,0,0 --direction 0,0,1", "0 surfaces are given, expected one of --triangle"},
       {"oracle ray --sphere 0,0,0,1 --box 0,0,0,1,1,1 --origin 0,0,0 --direction 0,0,1", "2 surfaces are given"},
       {"oracle ray --triangle 0,0,0 --origin 0,0,0 --direction 0,0,1", "--triangle: '0,0,0', expected 9 numbers"},
       {"oracle ray --sphere 0,0,0,x --origin 0,0,0 --direction 0,0,1", "--sphere"},
       {"oracle ray --sphere 0,0,0,1 --origin 0,0,0 --direction 0,0,0", "a direction of zero"},
       {"oracle ray --sphere 0,0,0,-1 --origin 0,0,0 --direction 0,0,1", "a negative radius"},
       {"oracle matrix", "nothing is asked"}}};
  for (const auto& [words, message] : mistakes) {
    EXPECT_EQ(plumb(words), 2) << words;
    EXPECT_THAT(complained_, HasSubstr(message)) << words;
  }
}

}  // namespace
}  // namespace plumb

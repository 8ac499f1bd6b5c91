// The kill matrix as text, tables and a page, from a score made by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "reports/kill_matrix_html.h"
#include "reports/kill_matrix_tables.h"
#include "reports/kill_matrix_text.h"

namespace plumb {
namespace {

using testing::HasSubstr;
using testing::Not;

ScoreCell noticed(std::int64_t pixels, bool named) {
  return {.notice = Notice::wrong, .named = named, .wrong_pixels = pixels, .found = "so many pixels are wrong"};
}
ScoreCell right(bool named = false) { return {.notice = Notice::right, .named = named, .found = ""}; }

SuiteScore score() {
  SuiteScore s;
  s.suite_id = "two <balls>", s.suite_hash = "abc", s.plumb_version = "1.2.3", s.seed = 7, s.intensity = 0.5;
  s.columns = {{.id = "ball", .kind = "image", .fault = "", .noticed = 2, .only_here = {"flat"}},
               {.id = "egg", .kind = "image", .fault = "", .noticed = 0, .only_here = {}},
               {.id = "growth", .kind = "growth", .fault = "", .noticed = 0, .only_here = {}},
               {.id = "check:S0", .kind = "check", .fault = "", .noticed = 1, .only_here = {}}};
  ScoreRow flat{
      .id = "flat", .name = "The \"ball\" is flat", .step = "surfaces", .variant = "", .cells = {}, .missing = {}};
  flat.verdict = MutantVerdict::caught;
  flat.cells = {noticed(12, true), right(), {}, noticed(0, true)};
  ScoreRow dim{.id = "dim", .name = "Too dim", .step = "lights", .variant = "", .cells = {}, .missing = {}};
  dim.verdict = MutantVerdict::elsewhere;
  dim.cells = {
      {.notice = Notice::no_picture, .named = false, .found = "there is no usable picture"}, right(true), {}, {}};
  dim.missing = {"egg: finds nothing wrong, or so"};
  ScoreRow up{.id = "up", .name = "Rounded up", .step = "lights", .variant = "up", .cells = {}, .missing = {}};
  up.verdict = MutantVerdict::accepted;
  up.cells = {{.notice = Notice::by_variant, .named = false, .wrong_pixels = 5, .found = "5 pixels"}, right(), {}, {}};
  s.rows = {flat, dim, up};
  return s;
}

TEST(KillMatrixText, IsASignAPlaceWithALineForWhatDoesNotHold) {
  EXPECT_EQ(
      kill_matrix_text(score()),
      "         c\n"
      "         h\n"
      "        ge\n"
      "        rc\n"
      "      b ok\n"
      "      aew:\n"
      "      lgtS\n"
      "      lgh0\n"
      "surfaces\n"
      "flat  #. #\n"
      "lights\n"
      "dim   +!    caught only by what it does not name\n"
      "up    ~.    accepted as the variant up\n"
      "# noticed, + by what the mutant does not name; . right, ! though named; ~ a warning, or right by another "
      "variant; ? undecided\n"
      "\nNoticed by no other case than\n"
      "  ball: flat\n"
      "\nCases that notice nothing: egg\n"
      "\nCases that no mutant here names: growth\n"
      "\ndim (caught only by what it does not name): egg: finds nothing wrong, or so\n"
      "\nSuite two <balls>, seed 7, intensity 0.5: caught by all that they name: 1 of 2 known mistakes; 1 only by "
      "what they do not name; 1 more accepted as variants\n");
}

TEST(KillMatrixCsv, HasWrongPixelsOrAWord) {
  EXPECT_EQ(kill_matrix_csv(score()),
            "mutant,step,verdict,missing,ball,egg,growth,check:S0\n"
            "flat,surfaces,caught,,12,0,not_asked,wrong\n"
            "dim,lights,elsewhere,\"egg: finds nothing wrong, or so\",no_picture,0,not_asked,not_asked\n"
            "up,lights,accepted,,5,0,not_asked,not_asked\n");
}

TEST(KillMatrixJson, HoldsAll) {
  const nlohmann::json json = nlohmann::json::parse(kill_matrix_json(score()));
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["suite"]["id"], "two <balls>");
  EXPECT_EQ(json["seed"], 7);
  EXPECT_EQ(json["counts"]["mutants"], 3);
  EXPECT_EQ(json["counts"]["to_catch"], 2);
  EXPECT_EQ(json["counts"]["elsewhere"], 1);
  EXPECT_EQ(json["columns"][0]["only_here"], nlohmann::json({"flat"}));
  EXPECT_EQ(json["mutants"][0]["cells"]["ball"]["wrong_pixels"], 12);
  EXPECT_EQ(json["mutants"][0]["cells"]["ball"]["named"], true);
  EXPECT_FALSE(json["mutants"][1]["cells"].contains("check:S0")) << "not asked";
  EXPECT_EQ(json["mutants"][1]["missing"].size(), 1u);
  EXPECT_EQ(json["mutants"][2]["variant"], "up");
}

TEST(KillMatrixHtml, StandsAloneAndTellsItsPlaces) {
  const std::string page = kill_matrix_html(score());
  for (const char* foreign : {"http:", "https:", "<script", "<link", "url(", "@import", "src="})
    EXPECT_THAT(page, Not(HasSubstr(foreign)));
  EXPECT_THAT(page, HasSubstr("position: sticky"));
  EXPECT_THAT(page, HasSubstr("<h1>Kill matrix of the suite two &lt;balls&gt;</h1>"));
  EXPECT_THAT(page,
              HasSubstr("<tr><th title=\"The &quot;ball&quot; is flat\">flat</th><td class=\"cell named\" "
                        "title=\"flat, ball: 12 wrong pixels (so many pixels are wrong); the mutant names it\">&#9679;"
                        "</td><td class=\"cell idle\" title=\"flat, egg: 0 wrong pixels\">&#183;</td>"));
  EXPECT_THAT(page, HasSubstr("<td class=\"cell other\" title=\"dim, ball: there is no usable picture\">&#9675;</td>"
                              "<td class=\"cell lacking\" title=\"dim, egg: 0 wrong pixels; the mutant names it\">!"
                              "</td><td class=\"cell\"></td><td class=\"cell\"></td><td class=\"bad\">caught only by "
                              "what it does not name"));
  EXPECT_THAT(page, HasSubstr("<td class=\"cell weak\""));
  EXPECT_THAT(page, HasSubstr("<li><b>dim</b> (caught only by what it does not name): egg: finds nothing wrong"));
  EXPECT_THAT(page, HasSubstr("<tr><th>egg</th><td>image</td><td class=\"bad\">0</td><td></td></tr>"));
}

TEST(KillMatrix, AFaultOfOursIsSaidEverywhere) {
  SuiteScore s = score();
  s.columns[3].fault = "the centre is off";
  EXPECT_THAT(kill_matrix_text(s),
              HasSubstr("check:S0: not right with the tracer without mistakes: the centre is off\n"));
  EXPECT_THAT(kill_matrix_html(s), HasSubstr("<li><b>check:S0</b>: not right with the tracer without mistakes"));
  EXPECT_EQ(nlohmann::json::parse(kill_matrix_json(s))["columns"][3]["fault"], "the centre is off");
  EXPECT_EQ(s.exit_status(), 3);
  EXPECT_EQ(score().exit_status(), 1);
}

}  // namespace
}  // namespace plumb

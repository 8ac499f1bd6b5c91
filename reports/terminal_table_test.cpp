#include "reports/terminal_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace plumb {
namespace {

using testing::HasSubstr;
using testing::Not;

CaseResult a_case(const std::string& id, Verdict verdict, double points, double max_points) {
  CaseResult c;
  c.id = id;
  c.check.verdict = verdict;
  c.check.summary = "evidence of " + id;
  c.points = points;
  c.max_points = max_points;
  return c;
}

TEST(TerminalTable, HoldsACaseALineAndWhatToDo) {
  ResultSet results;
  results.cases = {a_case("sphere", Verdict::pass, 8, 8), a_case("a-long-name", Verdict::fail, 0, 2.5)};
  results.cases[1].check.advice = "look at pixel (1,0)";
  EXPECT_EQ(terminal_table(results, {}),
            "case         verdict           points  evidence\n"
            "sphere       pass                 8/8  evidence of sphere\n"
            "a-long-name  fail               0/2.5  evidence of a-long-name\n"
            "             -> look at pixel (1,0)\n"
            "total                          8/10.5\n");
}

TEST(TerminalTable, PendingAndExcludedPointsCountNeitherWay) {
  ResultSet results;
  results.cases = {a_case("right", Verdict::pass, 5, 5), a_case("ours", Verdict::internal_error, 0, 7),
                   a_case("left-out", Verdict::skipped, 0, 3)};
  results.cases[1].pending = true;
  results.cases[2].excluded = true;
  const std::string table = terminal_table(results, {});
  EXPECT_THAT(table, HasSubstr("ours      internal_error       ?/7  "));
  EXPECT_THAT(table, HasSubstr("left-out  skipped                -  "));
  EXPECT_THAT(table, HasSubstr("total                          5/5\n7 points wait for a person\n"));
}

TEST(TerminalTable, EveryVerdictFitsItsColumn) {
  ResultSet results;
  for (const Verdict verdict : {Verdict::pass, Verdict::quality_warning, Verdict::fail, Verdict::timeout,
                                Verdict::memory_limit, Verdict::output_limit, Verdict::crash, Verdict::security,
                                Verdict::unsupported, Verdict::skipped, Verdict::internal_error})
    results.cases.push_back(a_case(std::string(to_string(verdict)), verdict, 1, 1));
  const std::string table = terminal_table(results, {});
  const std::size_t column = table.find("evidence");
  ASSERT_NE(column, std::string::npos);
  std::size_t lines = 0;
  for (std::size_t at = table.find('\n') + 1; lines < results.cases.size(); at = table.find('\n', at) + 1, ++lines)
    EXPECT_EQ(table.compare(at + column, 12, "evidence of "), 0) << table.substr(at, column + 12);
  EXPECT_EQ(lines, 11U);
}

TEST(TerminalTable, NotesFollowTheTotals) {
  ResultSet results;
  results.cases = {a_case("a", Verdict::pass, 1, 1)};
  results.notes = {"left out, as it is no ordinary file: link"};
  EXPECT_THAT(terminal_table(results, {}), testing::EndsWith("1/1\nnote: left out, as it is no ordinary file: link\n"));
}

TEST(TerminalTable, WhatAProgramSaidCannotCommandTheTerminal) {
  ResultSet results;
  results.cases = {a_case("a", Verdict::fail, 0, 1)};
  results.cases[0].check.summary = "\x1b]0;title\x07 and\nnew line\x7f";
  results.cases[0].check.advice = "\x1b[2J\rover";
  results.notes = {"left out: a\x1b[31m\nb"};
  const std::string table = terminal_table(results, {});
  for (const char* bad : {"\x1b", "\x07", "\r", "\x7f"}) EXPECT_THAT(table, Not(HasSubstr(bad)));
  EXPECT_THAT(table, HasSubstr("?]0;title? and?new line?\n"));
  EXPECT_THAT(table, HasSubstr("-> ?[2J?over\n"));
  EXPECT_THAT(table, HasSubstr("note: left out: a?[31m?b\n"));
}

TEST(TerminalTable, ColoursSurroundTheVerdictAlone) {
  ResultSet results;
  results.cases = {a_case("a", Verdict::pass, 1, 1), a_case("b", Verdict::fail, 0, 1)};
  const std::string table = terminal_table(results, {.color = true});
  EXPECT_THAT(table, HasSubstr("a     \x1b[32mpass           \x1b[0m      1/1  evidence of a\n"));
  EXPECT_THAT(table, HasSubstr("\x1b[31mfail           \x1b[0m"));
  EXPECT_THAT(terminal_table(results, {}), Not(HasSubstr("\x1b")));
}

}  // namespace
}  // namespace plumb

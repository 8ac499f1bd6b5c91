// Tables, CSV and scripts of speed against error, from results made by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "reports/gnuplot_panels.h"
#include "reports/pareto_csv.h"
#include "reports/pareto_plots.h"
#include "reports/pareto_text.h"

namespace plumb {
namespace {

using testing::HasSubstr;
using testing::Not;

ParetoResults results() {
  ParetoKernel kernel{"mt-float", "float", "a \"test\", in floats", {100, 5, 1.0 / 3, 0.25, 0.5}, {}, {}, {}};
  ClassFigure edge;
  edge.family = "T1", edge.name = "edge";
  edge.rays = 1000, edge.false_misses = 7, edge.farthest_u = 0.1, edge.right_hits = 3, edge.t_ulps_p99 = 2.5;
  kernel.classes.push_back(edge);
  EscapeFigure escapes;
  escapes.aim = "vertices", escapes.rays = 300'000;
  kernel.escapes.push_back(escapes);
  ClosestFigure closest;
  closest.scene = "sphere", closest.aim = "edges";
  kernel.closest.push_back(closest);
  ParetoResults all;
  all.plumb_version = "1.2.3", all.processor = "a processor";
  all.triangles.push_back(kernel);
  kernel.name = "sphere-it";
  all.spheres.push_back(kernel);
  all.pictures.push_back({"glass", 12, 9, 4, 256, 0.02, 0.5, 0.125});
  all.pictures.push_back({"glass", 12, 9, 9, 256, 0, 0, 0.25});
  return all;
}

/// Lines of fields, by the rules of RFC 4180.
std::vector<std::vector<std::string>> parsed(const std::string& text) {
  std::vector<std::vector<std::string>> lines{{""}};
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"')
      lines.back().back() += text[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      lines.back().emplace_back();
    else if (c == '\n' && !quoted)
      lines.push_back({""});
    else
      lines.back().back() += c;
  }
  lines.pop_back();
  return lines;
}

std::string field(const std::string& text, std::size_t line, const std::string& column) {
  const auto lines = parsed(text);
  for (std::size_t i = 0; i < lines.at(0).size(); ++i)
    if (lines[0][i] == column) return lines.at(line).at(i);
  return "no column " + column;
}

std::string file(const std::vector<ReportFile>& files, const std::string& name) {
  for (const ReportFile& one : files)
    if (one.name == name) return one.text;
  return "no file " + name;
}

TEST(ParetoText, NoneOfNIsWrittenAsItsBound) {
  EXPECT_EQ(rate_text({0, 100'000}), "<30");
  EXPECT_EQ(rate_text({0, 30'000'000}), "<0.1");
  EXPECT_EQ(rate_text({113'218, 1'000'000}), "113218");
  EXPECT_EQ(rate_text({5, 2'000'000}), "2.5");
  EXPECT_EQ(rate_text({0, 0}), "-");
}

TEST(ParetoText, HasEachFigureApart) {
  const std::string text = pareto_text(results());
  EXPECT_THAT(text, HasSubstr("T1 edge"));
  EXPECT_THAT(text, HasSubstr("7000/<3000"));
  EXPECT_THAT(text, HasSubstr("7000/<3000/<3000"));
  EXPECT_THAT(text, HasSubstr("escapes from closed meshes"));
  EXPECT_THAT(text, HasSubstr("<10"));
  EXPECT_THAT(text, HasSubstr("glass"));
  EXPECT_THAT(text, Not(HasSubstr("not finite"))) << "only where there are any";
}

TEST(ParetoText, AKernelThatFailedHasADash) {
  ParetoResults all = results();
  all.triangles[0].speed.rounds = 0;
  all.triangles[0].classes[0].rays = 0;
  all.notes = {"it crashed"};
  const std::string text = pareto_text(all);
  EXPECT_THAT(text, testing::ContainsRegex("million rays/s +-\n"));
  EXPECT_THAT(text, testing::ContainsRegex("T1 edge +-\n"));
  EXPECT_THAT(text, HasSubstr("note: it crashed\n"));
}

TEST(ParetoCsv, ReadsBackToTheSame) {
  const std::vector<ReportFile> files = pareto_csv(results());
  ASSERT_EQ(files.size(), 6u);
  for (const ReportFile& one : files) {
    const auto lines = parsed(one.text);
    ASSERT_GE(lines.size(), 2u) << one.name;
    for (const auto& line : lines) EXPECT_EQ(line.size(), lines[0].size()) << one.name;
  }
  const std::string kernels = file(files, "kernels.csv");
  EXPECT_EQ(field(kernels, 1, "description"), "a \"test\", in floats");
  EXPECT_EQ(std::strtod(field(kernels, 1, "million_rays_a_second").c_str(), nullptr), 1.0 / 3);
  const std::string classes = file(files, "class.csv");
  EXPECT_EQ(field(classes, 1, "surface"), "triangle");
  EXPECT_EQ(field(classes, 2, "surface"), "sphere");
  EXPECT_EQ(field(classes, 1, "false_misses"), "7");
  EXPECT_EQ(field(classes, 1, "wrong_per_million"), "7000");
  EXPECT_EQ(std::strtod(field(classes, 1, "farthest_u").c_str(), nullptr), 0.1);
  EXPECT_EQ(field(file(files, "escapes.csv"), 1, "bound_of_none_per_million"), "10");
  EXPECT_EQ(field(file(files, "pictures.csv"), 2, "cpu_seconds"), "0.25");
}

TEST(ParetoCsv, QuotesWhatNeedsIt) {
  EXPECT_EQ(csv_field("plain"), "plain");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("say \"x\""), "\"say \"\"x\"\"\"");
  EXPECT_EQ(csv_field("two\nlines"), "\"two\nlines\"");
}

TEST(ParetoPlots, NoneIsAnOpenPointAtItsBound) {
  const std::vector<ReportFile> plots = pareto_plots(results());
  ASSERT_EQ(plots.size(), 5u);
  const std::string classes = file(plots, "class.gnuplot");
  EXPECT_THAT(classes, HasSubstr("0.3333333333333333 7000\n"));
  EXPECT_THAT(classes, HasSubstr("with points pt 7"));
  const std::string escapes = file(plots, "escapes.gnuplot");
  EXPECT_THAT(escapes, HasSubstr("0.3333333333333333 10\n"));
  EXPECT_THAT(escapes, HasSubstr("with points pt 6"));
  EXPECT_THAT(file(plots, "closest.gnuplot"), HasSubstr("plot 1/0")) << "nothing was asked";
  EXPECT_THAT(file(plots, "pictures.gnuplot"), HasSubstr("0.125 0.02 \"4\"\n"));
  EXPECT_THAT(file(plots, "pictures.gnuplot"), Not(HasSubstr("0.25 0 \"9\""))) << "no place on a logarithmic axis";
}

TEST(GnuplotQuoted, HoldsAnyText) {
  EXPECT_EQ(gnuplot_quoted("mt-float"), "'mt-float'");
  EXPECT_EQ(gnuplot_quoted("it's `x` \"y\" $z\\"), "'it''s `x` \"y\" $z\\'");
  EXPECT_EQ(gnuplot_quoted("a\nsystem('b')"), "'a system(''b'')'");
}

}  // namespace
}  // namespace plumb

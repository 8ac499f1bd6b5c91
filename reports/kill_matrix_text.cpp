#include "reports/kill_matrix_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumb {
namespace {

char symbol(const ScoreCell& cell) {
  switch (cell.notice) {
    case Notice::not_asked:
      return ' ';
    case Notice::right:
      return cell.named ? '!' : '.';
    case Notice::warning:
    case Notice::by_variant:
      return cell.named ? '!' : '~';
    case Notice::undecided:
      return '?';
    default:
      return cell.named ? '#' : '+';
  }
}

/// Without blanks at its end.
std::string trimmed(const std::string& line) { return line.substr(0, line.find_last_not_of(' ') + 1); }

/// The columns' names, written downwards.
std::string heading(const SuiteScore& score, std::size_t indent) {
  std::size_t height = 0;
  for (const ScoreColumn& c : score.columns) height = std::max(height, c.id.size());
  std::string text;
  for (std::size_t line = 0; line < height; ++line) {
    std::string row(indent, ' ');
    for (const ScoreColumn& c : score.columns) {
      const std::size_t above = height - c.id.size();
      row += line < above ? ' ' : c.id[line - above];
    }
    text += trimmed(row) + "\n";
  }
  return text;
}

std::string matrix(const SuiteScore& score) {
  std::size_t width = 0;
  for (const ScoreRow& row : score.rows) width = std::max(width, row.id.size());
  std::string text = heading(score, width + 2);
  std::string step;
  for (const ScoreRow& row : score.rows) {
    if (row.step != step) text += row.step + "\n";
    step = row.step;
    std::string line = fmt::format("{:<{}}  ", row.id, width);
    for (const ScoreCell& cell : row.cells) line += symbol(cell);
    if (row.verdict != MutantVerdict::caught) line += "  " + verdict_text(row);
    text += trimmed(line) + "\n";
  }
  return text +
         "# noticed, + by what the mutant does not name; . right, ! though named; ~ a warning, or right by another "
         "variant; ? undecided\n";
}

std::string joined(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, ", ")); }

std::string worth(const SuiteScore& score) {
  std::string alone;
  std::vector<std::string> idle, not_asked;
  for (std::size_t i = 0; i < score.columns.size(); ++i) {
    const ScoreColumn& c = score.columns[i];
    if (!c.only_here.empty()) alone += fmt::format("  {}: {}\n", c.id, joined(c.only_here));
    const bool asked =
        std::ranges::any_of(score.rows, [&](const ScoreRow& row) { return row.cells[i].notice != Notice::not_asked; });
    if (c.kind != "check" && c.noticed == 0) (asked ? idle : not_asked).push_back(c.id);
  }
  std::string text;
  if (!alone.empty()) text += "\nNoticed by no other case than\n" + alone;
  if (!idle.empty()) text += "\nCases that notice nothing: " + joined(idle) + "\n";
  if (!not_asked.empty()) text += "\nCases that no mutant here names: " + joined(not_asked) + "\n";
  return text;
}

std::string problems(const SuiteScore& score) {
  std::string text;
  for (const ScoreColumn& c : score.columns)
    if (!c.fault.empty()) text += fmt::format("{}: not right with the tracer without mistakes: {}\n", c.id, c.fault);
  for (const ScoreRow& row : score.rows)
    for (const std::string& what : row.missing) text += fmt::format("{} ({}): {}\n", row.id, verdict_text(row), what);
  return text.empty() ? "" : "\n" + text;
}

}  // namespace

std::string verdict_text(const ScoreRow& row) {
  switch (row.verdict) {
    case MutantVerdict::caught:
      return "caught";
    case MutantVerdict::partly_caught:
      return "caught by some of what it names";
    case MutantVerdict::elsewhere:
      return "caught only by what it does not name";
    case MutantVerdict::survives:
      return "survives";
    case MutantVerdict::accepted:
      return "accepted as the variant " + row.variant;
    case MutantVerdict::not_accepted:
      return "not what the variant " + row.variant + " draws";
    case MutantVerdict::equivalent:
      return "equivalent";
    case MutantVerdict::not_equivalent:
      return "not equivalent";
  }
  return "";
}

std::string score_summary(const SuiteScore& score) {
  std::string text = fmt::format("caught by all that they name: {} of {} known mistakes",
                                 score.count(MutantVerdict::caught), score.to_catch());
  const auto add = [&](MutantVerdict verdict, const char* what) {
    if (const int n = score.count(verdict); n > 0) text += fmt::format("; {} {}", n, what);
  };
  add(MutantVerdict::partly_caught, "by some of what they name");
  add(MutantVerdict::elsewhere, "only by what they do not name");
  add(MutantVerdict::survives, "by nothing");
  add(MutantVerdict::accepted, "more accepted as variants");
  add(MutantVerdict::equivalent, "more equivalent");
  add(MutantVerdict::not_accepted, "more said to be accepted that are not");
  add(MutantVerdict::not_equivalent, "more said to be equivalent that are not");
  return text;
}

std::string kill_matrix_text(const SuiteScore& score) {
  return matrix(score) + worth(score) + problems(score) +
         fmt::format("\nSuite {}, seed {}, intensity {:g}: {}\n", score.suite_id, score.seed, score.intensity,
                     score_summary(score));
}

}  // namespace plumb

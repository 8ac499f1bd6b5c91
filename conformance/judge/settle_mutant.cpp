#include "conformance/judge/settle_mutant.h"

#include <algorithm>

namespace plumb {
namespace {

bool notices(const ScoreColumn& column, const ScoreCell& cell) {
  return column.fault.empty() && is_noticed(cell.notice);
}

std::string unnoticed_text(const ScoreCell& cell) {
  switch (cell.notice) {
    case Notice::right:
      return "finds nothing wrong";
    case Notice::not_asked:
      return "was not asked";
    default:
      return cell.found;
  }
}

/// Why a case or check that has to notice the mutant does not; empty if it does.
std::string lacking(const std::string& name, std::span<const ScoreColumn> columns, const ScoreRow& row) {
  const auto column = std::ranges::find(columns, name, &ScoreColumn::id);
  if (column == columns.end()) return name + ": the suite has no such case with an envelope";
  if (!column->fault.empty()) return name + ": is not right with the tracer without mistakes, either";
  const ScoreCell& cell = row.cells[static_cast<std::size_t>(column - columns.begin())];
  return is_noticed(cell.notice) ? "" : name + ": " + unnoticed_text(cell);
}

void settle_caught(const Mutant& mutant, std::span<const ScoreColumn> columns, ScoreRow& row) {
  for (const std::string& name : mutant.caught_by)
    if (std::string text = lacking(name, columns, row); !text.empty()) row.missing.push_back(std::move(text));
  bool any = false;
  for (std::size_t i = 0; i < columns.size(); ++i) any = any || notices(columns[i], row.cells[i]);
  if (row.missing.empty())
    row.verdict = MutantVerdict::caught;
  else if (row.missing.size() < mutant.caught_by.size())
    row.verdict = MutantVerdict::partly_caught;
  else
    row.verdict = any ? MutantVerdict::elsewhere : MutantVerdict::survives;
}

void settle_accepted(const std::map<std::string, CheckResult>& by_variant, ScoreRow& row) {
  if (by_variant.empty()) row.missing.push_back("the suite accepts no variant '" + row.variant + "'");
  for (const auto& [id, result] : by_variant)
    if (!is_right(result.verdict))
      row.missing.push_back(id + ": is not right by the variant '" + row.variant + "': " + result.summary);
  row.verdict = row.missing.empty() ? MutantVerdict::accepted : MutantVerdict::not_accepted;
}

void settle_equivalent(std::span<const ScoreColumn> columns, ScoreRow& row) {
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (const Notice notice = row.cells[i].notice; notice != Notice::right && notice != Notice::not_asked)
      row.missing.push_back(columns[i].id + ": " + row.cells[i].found);
  row.verdict = row.missing.empty() ? MutantVerdict::equivalent : MutantVerdict::not_equivalent;
}

}  // namespace

void settle_mutant(const Mutant& mutant, std::span<const ScoreColumn> columns,
                   const std::map<std::string, CheckResult>& by_accepted_variant, ScoreRow& row) {
  if (!mutant.accepted.empty())
    settle_accepted(by_accepted_variant, row);
  else if (!mutant.equivalent.empty())
    settle_equivalent(columns, row);
  else
    settle_caught(mutant, columns, row);
}

void count_noticed(SuiteScore& score) {
  for (const ScoreRow& row : score.rows) {
    std::vector<ScoreColumn*> cases;
    for (std::size_t i = 0; i < score.columns.size(); ++i) {
      ScoreColumn& column = score.columns[i];
      if (!notices(column, row.cells[i])) continue;
      ++column.noticed;
      if (column.kind != "check") cases.push_back(&column);
    }
    if (cases.size() == 1) cases.front()->only_here.push_back(row.id);
  }
}

}  // namespace plumb

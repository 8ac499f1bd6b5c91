#include "reports/kill_matrix_html.h"

#include <fmt/format.h>

#include "reports/kill_matrix_text.h"

namespace plumb {
namespace {

constexpr const char* kStyle = R"(
body { font: 15px/1.45 system-ui, sans-serif; margin: 1.5em; color: #1c2024; background: #fff }
h1 { font-size: 1.4em } h2 { font-size: 1.15em; margin-top: 2em }
.matrix { overflow: auto; max-height: 85vh; border: 1px solid #c6ccd2 }
table { border-collapse: separate; border-spacing: 0 }
th, td { padding: 2px 6px; border-bottom: 1px solid #e6e9ec; text-align: left; font-weight: normal }
thead th { position: sticky; top: 0; z-index: 2; background: #f3f5f7; vertical-align: bottom }
thead th, .matrix tbody th { border-color: #c6ccd2 }
thead th.down { padding: 6px 2px }
thead th.down span { writing-mode: vertical-rl; transform: rotate(180deg); white-space: nowrap }
tbody th { position: sticky; left: 0; z-index: 1; background: #fff; white-space: nowrap }
.matrix th:first-child { border-right: 1px solid #c6ccd2 }
thead th:first-child { left: 0; z-index: 3 }
tbody th.step { background: #f3f5f7; font-weight: 600 }
.matrix td.cell { width: 1.2em; padding: 2px 3px; text-align: center; border-left: 1px solid #eef0f2 }
.named { background: #1f7a3d; color: #fff } .other { background: #b9dfc4 } .weak { background: #f6e3a1 }
.lacking { background: #c62828; color: #fff } .idle { color: #b4bac0 }
.bad { color: #b71c1c; font-weight: 600 }
.key span { display: inline-block; min-width: 1.4em; text-align: center; margin-left: 1em }
)";

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

/// The class that colours a place, and its sign: colour alone tells nothing to some.
std::pair<const char*, const char*> look(const ScoreCell& cell) {
  if (cell.notice == Notice::not_asked) return {"", ""};
  if (is_noticed(cell.notice)) return cell.named ? std::pair{"named", "&#9679;"} : std::pair{"other", "&#9675;"};
  if (cell.named) return {"lacking", "!"};
  if (cell.notice == Notice::right) return {"idle", "&#183;"};
  return {"weak", "~"};
}

std::string tooltip(const ScoreColumn& column, const ScoreRow& row, const ScoreCell& cell) {
  std::string text = row.id + ", " + column.id + ": ";
  if (column.kind == "image" && cell.notice != Notice::no_picture)
    text += cell.wrong_pixels == 1 ? "1 wrong pixel" : fmt::format("{} wrong pixels", cell.wrong_pixels);
  else
    text += cell.notice == Notice::right ? "finds nothing wrong" : cell.found;
  if (column.kind == "image" && cell.wrong_pixels > 0) text += " (" + cell.found + ")";
  return text + (cell.named ? "; the mutant names it" : "");
}

std::string matrix_row(const SuiteScore& score, const ScoreRow& row) {
  std::string text = fmt::format("<tr><th title=\"{}\">{}</th>", escaped(row.name), escaped(row.id));
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    const auto [kind, sign] = look(row.cells[i]);
    if (row.cells[i].notice == Notice::not_asked)
      text += "<td class=\"cell\"></td>";
    else
      text += fmt::format("<td class=\"cell {}\" title=\"{}\">{}</td>", kind,
                          escaped(tooltip(score.columns[i], row, row.cells[i])), sign);
  }
  const std::string verdict = escaped(verdict_text(row));
  return text +
         (is_settled(row.verdict) ? fmt::format("<td>{}</td>", verdict)
                                  : fmt::format("<td class=\"bad\">{}</td>", verdict)) +
         "</tr>\n";
}

std::string matrix(const SuiteScore& score) {
  std::string text = "<div class=\"matrix\"><table>\n<thead><tr><th>mutant</th>";
  for (const ScoreColumn& c : score.columns)
    text += fmt::format("<th class=\"down{}\" title=\"{}\"><span>{}</span></th>", c.fault.empty() ? "" : " bad",
                        escaped(c.fault), escaped(c.id));
  text += "<th>verdict</th></tr></thead>\n<tbody>\n";
  std::string step;
  for (const ScoreRow& row : score.rows) {
    if (row.step != step)
      text += fmt::format("<tr><th class=\"step\">{}</th><td colspan=\"{}\"></td></tr>\n", escaped(row.step),
                          score.columns.size() + 1);
    step = row.step;
    text += matrix_row(score, row);
  }
  return text + "</tbody></table></div>\n";
}

std::string problems(const SuiteScore& score) {
  std::string items;
  for (const ScoreColumn& c : score.columns)
    if (!c.fault.empty())
      items += fmt::format("<li><b>{}</b>: not right with the tracer without mistakes: {}</li>\n", escaped(c.id),
                           escaped(c.fault));
  for (const ScoreRow& row : score.rows)
    for (const std::string& what : row.missing)
      items += fmt::format("<li><b>{}</b> ({}): {}</li>\n", escaped(row.id), escaped(verdict_text(row)), escaped(what));
  return items.empty() ? "" : "<h2>What does not hold</h2>\n<ul>\n" + items + "</ul>\n";
}

std::string worth(const SuiteScore& score) {
  std::string text =
      "<h2>What the cases are worth</h2>\n<table>\n<thead><tr><th>case or check</th><th>kind</th><th>mutants "
      "noticed</th><th>noticed by no other case</th></tr></thead>\n<tbody>\n";
  for (const ScoreColumn& c : score.columns)
    text += fmt::format("<tr><th>{}</th><td>{}</td><td{}>{}</td><td>{}</td></tr>\n", escaped(c.id), escaped(c.kind),
                        c.noticed == 0 ? " class=\"bad\"" : "", c.noticed,
                        escaped(fmt::format("{}", fmt::join(c.only_here, ", "))));
  return text + "</tbody></table>\n";
}

}  // namespace

std::string kill_matrix_html(const SuiteScore& score) {
  const std::string id = escaped(score.suite_id);
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Kill matrix of " + id +
         "</title>\n<style>" + kStyle + "</style></head>\n<body>\n<h1>Kill matrix of the suite " + id + "</h1>\n<p>" +
         escaped(score_summary(score)) +
         fmt::format(".</p>\n<p>Checks with seed {} and intensity {:g}; plumb {}.</p>\n", score.seed, score.intensity,
                     escaped(score.plumb_version)) +
         "<p class=\"key\"><span class=\"named\">&#9679;</span> noticed <span class=\"other\">&#9675;</span> noticed, "
         "not named <span class=\"idle\">&#183;</span> right <span class=\"lacking\">!</span> named, not noticed <span "
         "class=\"weak\">~</span> a warning, right by another variant, or undecided</p>\n" +
         problems(score) + matrix(score) + worth(score) + "</body></html>\n";
}

}  // namespace plumb

#include "reports/terminal_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace plumb {
namespace {

/// Texts may quote what a program printed or what a file is named.
std::string harmless(std::string_view text) {
  std::string result;
  for (const char c : text) result += (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) ? '?' : c;
  return result;
}

std::string_view color_of(Verdict verdict) {
  if (verdict == Verdict::pass) return "\x1b[32m";
  if (verdict == Verdict::quality_warning || verdict == Verdict::skipped) return "\x1b[33m";
  return verdict == Verdict::internal_error ? "\x1b[35m" : "\x1b[31m";
}

std::string points_text(const CaseResult& c) {
  if (c.pending) return "?/" + fmt::format("{:g}", c.max_points);
  if (c.excluded) return "-";
  return fmt::format("{:g}/{:g}", c.points, c.max_points);
}

/// The likeliest mistakes, at most three, with a pixel where each can be seen.
std::string diagnosis_text(const ResultSet& results) {
  std::string text;
  if (!results.variant.empty() && results.variants.size() > 1)
    text += "judged by the variant '" + results.variant + "'\n";
  if (!results.diagnosis) return text;
  const std::vector<Suspicion>& suspicions = results.diagnosis->suspicions;
  if (suspicions.empty()) return text + "\nWhat is wrong: unknown, no known mistake draws such pictures.\n";
  text +=
      results.diagnosis->confident ? "\nWhat is wrong, most likely:\n" : "\nWhat may be wrong, the likeliest first:\n";
  constexpr std::size_t kMost = 3;
  for (std::size_t i = 0; i < std::min(kMost, suspicions.size()); ++i) {
    const Suspicion& s = suspicions[i];
    text += fmt::format("{}. {} (reproduces {:.0f} % of the wrong area", i + 1, harmless(s.name), 100 * s.explained);
    text += s.missed >= 0.005 ? fmt::format("; {:.0f} % of where it would show is right)\n", 100 * s.missed) : ")\n";
    if (!s.hint.empty()) text += "   " + harmless(s.hint) + "\n";
    for (const DiagnosisPixel& p : s.pixels)
      text += fmt::format("   {} ({},{}): expected {} {} {}, found {} {} {}, with this mistake {} {} {}\n", p.case_id,
                          p.x, p.y, p.expected[0], p.expected[1], p.expected[2], p.found[0], p.found[1], p.found[2],
                          p.suspected[0], p.suspected[1], p.suspected[2]);
    if (results.diagnosis->confident) break;
  }
  return text;
}

}  // namespace

std::string terminal_table(const ResultSet& results, const TableStyle& style) {
  std::size_t id_width = 4;
  for (const CaseResult& c : results.cases) id_width = std::max(id_width, c.id.size());
  std::string text = fmt::format("{:<{}}  {:<15}  {:>7}  {}\n", "case", id_width, "verdict", "points", "evidence");
  for (const CaseResult& c : results.cases) {
    const std::string verdict = fmt::format("{:<15}", to_string(c.check.verdict));
    const std::string shown = style.color ? fmt::format("{}{}\x1b[0m", color_of(c.check.verdict), verdict) : verdict;
    text += fmt::format("{:<{}}  {}  {:>7}  {}\n", c.id, id_width, shown, points_text(c), harmless(c.check.summary));
    if (!c.check.advice.empty()) text += fmt::format("{:<{}}  -> {}\n", "", id_width, harmless(c.check.advice));
  }
  const Totals totals = results.totals();
  text += fmt::format("{:<{}}  {:<15}  {:>7}\n", "total", id_width, "",
                      fmt::format("{:g}/{:g}", totals.points, totals.max_points));
  if (totals.pending_points > 0) text += fmt::format("{:g} points wait for a person\n", totals.pending_points);
  text += diagnosis_text(results);
  for (const std::string& note : results.notes) text += "note: " + harmless(note) + "\n";
  return text;
}

}  // namespace plumb

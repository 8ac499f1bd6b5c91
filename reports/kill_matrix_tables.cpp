#include "reports/kill_matrix_tables.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "reports/pareto_csv.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;
constexpr int kSchema = 1;

std::string field(const ScoreColumn& column, const ScoreCell& cell) {
  if (column.kind == "image" && cell.notice != Notice::no_picture) return std::to_string(cell.wrong_pixels);
  return to_string(cell.notice);
}

Json column_json(const ScoreColumn& c) {
  return {{"id", c.id}, {"kind", c.kind}, {"noticed", c.noticed}, {"only_here", c.only_here}, {"fault", c.fault}};
}

Json row_json(const ScoreRow& row, const std::vector<ScoreColumn>& columns) {
  Json json;
  json["id"] = row.id;
  json["name"] = row.name;
  json["step"] = row.step;
  json["variant"] = row.variant;
  json["verdict"] = to_string(row.verdict);
  json["missing"] = row.missing;
  json["cells"] = Json::object();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const ScoreCell& cell = row.cells[i];
    if (cell.notice == Notice::not_asked) continue;
    Json& found = json["cells"][columns[i].id];
    found = {{"notice", to_string(cell.notice)}, {"named", cell.named}};
    if (columns[i].kind == "image") found["wrong_pixels"] = cell.wrong_pixels;
    found["found"] = cell.found;
  }
  return json;
}

}  // namespace

std::string kill_matrix_csv(const SuiteScore& score) {
  std::string text = "mutant,step,verdict,missing";
  for (const ScoreColumn& c : score.columns) text += "," + csv_field(c.id);
  text += "\n";
  for (const ScoreRow& row : score.rows) {
    text += fmt::format("{},{},{},{}", csv_field(row.id), csv_field(row.step), to_string(row.verdict),
                        csv_field(fmt::format("{}", fmt::join(row.missing, "; "))));
    for (std::size_t i = 0; i < score.columns.size(); ++i) text += "," + field(score.columns[i], row.cells[i]);
    text += "\n";
  }
  return text;
}

std::string kill_matrix_json(const SuiteScore& score) {
  Json json;
  json["schema"] = kSchema;
  json["suite"] = {{"id", score.suite_id}, {"hash", score.suite_hash}};
  json["versions"] = {{"plumb", score.plumb_version}};
  json["seed"] = score.seed;
  json["intensity"] = score.intensity;
  json["counts"] = {{"mutants", score.rows.size()}, {"to_catch", score.to_catch()}};
  for (const MutantVerdict v :
       {MutantVerdict::caught, MutantVerdict::partly_caught, MutantVerdict::elsewhere, MutantVerdict::survives,
        MutantVerdict::accepted, MutantVerdict::not_accepted, MutantVerdict::equivalent, MutantVerdict::not_equivalent})
    json["counts"][to_string(v)] = score.count(v);
  json["columns"] = Json::array();
  for (const ScoreColumn& c : score.columns) json["columns"].push_back(column_json(c));
  json["mutants"] = Json::array();
  for (const ScoreRow& row : score.rows) json["mutants"].push_back(row_json(row, score.columns));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace plumb

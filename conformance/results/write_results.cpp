#include "conformance/results/write_results.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "renderer/image/staged_file.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kSchema = 1;

/// JSON has no infinities: they are texts.
Json number(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value;
}

Json evidence_json(const Evidence& evidence) {
  Json json = Json::object();
  for (const auto& [name, value] : evidence) {
    if (const auto* real = std::get_if<double>(&value))
      json[name] = number(*real);
    else
      std::visit([&](const auto& v) { json[name] = v; }, value);
  }
  return json;
}

Json case_json(const CaseResult& c, const std::string& plumb_version) {
  Json json;
  json["schema"] = kSchema;
  json["id"] = c.id;
  json["kind"] = c.kind;
  json["requirement"] = c.requirement;
  json["visibility"] = c.visibility;
  json["verdict"] = to_string(c.check.verdict);
  json["cause"] = c.check.cause;
  json["points"] = number(c.points);
  json["max_points"] = number(c.max_points);
  json["pending"] = c.pending;
  json["excluded"] = c.excluded;
  json["margin"] = c.check.margin ? number(*c.check.margin) : Json();
  json["summary"] = c.check.summary;
  json["advice"] = c.check.advice;
  json["evidence"] = evidence_json(c.check.evidence);
  json["hashes"]["inputs"] = Json::object();
  for (const auto& [name, hash] : c.input_hashes) json["hashes"]["inputs"][name] = hash;
  for (const auto& [name, hash] : c.hashes) json["hashes"][name] = hash;
  json["versions"] = {{"plumb", plumb_version}};
  json["seed"] = c.seed ? Json(*c.seed) : Json();  // nothing random decides an image case
  json["repeat"] = c.repeat;
  return json;
}

std::string host_name() {
  std::string name(256, '\0');
  if (::gethostname(name.data(), name.size() - 1) != 0) return "";
  return name.c_str();
}

Json curve_json(const GrowthCurve& curve) {
  Json json;
  json["name"] = curve.name;
  json["slope"] = {
      {"value", number(curve.slope.slope)}, {"low", number(curve.slope.low)}, {"high", number(curve.slope.high)}};
  json["points"] = Json::array();
  for (const GrowthPoint& point : curve.points)
    json["points"].push_back({{"size", number(point.size)}, {"seconds", number(point.seconds)}});
  return json;
}

Json growth_json(const GrowthFigures& growth) {
  Json json;
  json["of"] = growth.of;
  json["trace"] = to_string(growth.trace);
  json["build"] = to_string(growth.build);
  json["views"] = Json::array();
  for (const GrowthCurve& view : growth.views) json["views"].push_back(curve_json(view));
  json["building"] = curve_json(growth.building);
  json["start_seconds"] = number(growth.start_seconds);
  json["attempts"] = growth.attempts;
  json["rounds"] = growth.rounds;
  json["runs"] = growth.runs;
  json["cpu_seconds"] = number(growth.cpu_seconds);
  json["wall_seconds"] = number(growth.wall_seconds);
  json["seed"] = growth.seed;
  json["notes"] = growth.notes;
  return json;
}

Json usage_json(const CaseResult& c) {
  Json json;
  json["schema"] = kSchema;
  if (c.run) {
    const RunOutcome& run = *c.run;
    json["stopped"] = to_string(run.reason);
    json["exit_code"] = run.exit_code;
    json["signal"] = run.signal;
    json["cpu_seconds"] = number(run.cpu_seconds);
    json["wall_seconds"] = number(run.wall_seconds);
    json["peak_memory_bytes"] = run.peak_memory_bytes;
    json["output_bytes"] = run.output_bytes;
    json["log_bytes_dropped"] = run.log_bytes_dropped;
    json["active_limits"] = run.active_limits;
  }
  if (c.growth) json["growth"] = growth_json(*c.growth);
  if (!c.internal_message.empty()) json["internal_message"] = c.internal_message;
  if (c.measured_margin) json["margin"] = number(*c.measured_margin);
  json["host"] = {{"name", host_name()}, {"processors", std::thread::hardware_concurrency()}};
  return json;
}

std::string triple(const std::array<std::uint8_t, 3>& levels) {
  return std::to_string(levels[0]) + " " + std::to_string(levels[1]) + " " + std::to_string(levels[2]);
}

Json suspicion_json(const Suspicion& s) {
  Json json{{"id", s.id},
            {"name", s.name},
            {"hint", s.hint},
            {"parts", s.parts},
            {"or_one_of", s.or_one_of},
            {"explained", number(s.explained)},
            {"missed", number(s.missed)},
            {"likeness", number(s.likeness)},
            {"pixels", Json::array()}};
  for (const DiagnosisPixel& p : s.pixels)
    json["pixels"].push_back({{"case", p.case_id},
                              {"x", p.x},
                              {"y", p.y},
                              {"expected", triple(p.expected)},
                              {"found", triple(p.found)},
                              {"suspected", triple(p.suspected)}});
  return json;
}

Json results_json(const ResultSet& r) {
  const Totals totals = r.totals();
  Json json;
  json["schema"] = kSchema;
  json["suite"] = {{"id", r.suite_id}, {"hash", r.suite_hash}, {"dialect", r.dialect}, {"variants", r.variants}};
  json["variant"] = r.variant;
  json["submission"] = r.submission_id;
  json["versions"] = {{"plumb", r.plumb_version}};
  json["totals"] = {{"points", number(totals.points)},
                    {"max_points", number(totals.max_points)},
                    {"pending_points", number(totals.pending_points)}};
  json["notes"] = r.notes;
  json["diagnosis"] = Json();
  if (r.diagnosis) {
    json["diagnosis"] = {{"confident", r.diagnosis->confident}, {"suspicions", Json::array()}};
    for (const Suspicion& s : r.diagnosis->suspicions) json["diagnosis"]["suspicions"].push_back(suspicion_json(s));
  }
  json["cases"] = Json::array();
  for (const CaseResult& c : r.cases) {
    json["cases"].push_back({{"id", c.id},
                             {"verdict", to_string(c.check.verdict)},
                             {"cause", c.check.cause},
                             {"points", number(c.points)},
                             {"max_points", number(c.max_points)}});
  }
  return json;
}

/// Bytes of the submission may stand in texts; what is not UTF-8 becomes U+FFFD.
void write_json(const fs::path& file, const Json& json) {
  write_file_staged(file, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

/// Whether the folder is one that write_results made: its results.json names a schema and a suite.
bool is_result_set(const fs::path& dir) {
  std::ifstream stream(dir / "results.json");
  const Json json = Json::parse(stream, nullptr, false);
  return json.is_object() && json.contains("schema") && json.contains("suite");
}

bool may_be_replaced(const fs::path& dir) {
  return !fs::exists(fs::symlink_status(dir)) ||
         (fs::is_directory(fs::symlink_status(dir)) && (fs::is_empty(dir) || is_result_set(dir)));
}

}  // namespace

std::string results_text(const ResultSet& results) {
  Json json = results_json(results);
  json["cases"] = Json::array();
  for (const CaseResult& c : results.cases) json["cases"].push_back(case_json(c, results.plumb_version));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

ResultFolder::ResultFolder(fs::path dir, std::string plumb_version)
    : dir_(std::move(dir)), plumb_version_(std::move(plumb_version)) {
  if (!dir_.has_filename()) dir_ = dir_.parent_path();
  if (!may_be_replaced(dir_))
    throw InputError(
        {dir_.string()},
        "holds something that is no result set and would be lost, expected a new folder or an earlier result");
  std::error_code error;
  if (dir_.has_parent_path()) fs::create_directories(dir_.parent_path(), error);
  std::string partial = dir_.string() + ".partial-XXXXXX";
  if (error || !::mkdtemp(partial.data())) {
    throw InputError({dir_.string()},
                     "cannot make the folder for the results: " + (error ? error.message() : std::strerror(errno)));
  }
  partial_ = partial;
  fs::permissions(partial_,
                  fs::perms::group_read | fs::perms::group_exec | fs::perms::others_read | fs::perms::others_exec,
                  fs::perm_options::add);
}

ResultFolder::~ResultFolder() {
  std::error_code ignored;
  if (!fs::exists(partial_ / "cases", ignored)) fs::remove_all(partial_, ignored);
}

fs::path ResultFolder::case_folder(const std::string& id) const {
  fs::path folder = partial_ / "cases" / id;
  fs::create_directories(folder);
  return folder;
}

fs::path ResultFolder::build_folder() const {
  fs::path folder = partial_ / "build";
  fs::create_directories(folder);
  return folder;
}

void ResultFolder::write_case(const CaseResult& result) const {
  const fs::path folder = case_folder(result.id);
  write_json(folder / "case.json", case_json(result, plumb_version_));
  write_json(folder / "usage.json", usage_json(result));
}

void ResultFolder::finish(const ResultSet& results) const {
  write_json(partial_ / "results.json", results_json(results));
  if (::renameat2(AT_FDCWD, partial_.c_str(), AT_FDCWD, dir_.c_str(), RENAME_EXCHANGE) == 0) {
    fs::remove_all(partial_);  // the older set now has that name
  } else {
    fs::rename(partial_, dir_);  // there is none, or the file system cannot exchange
  }
}

}  // namespace plumb

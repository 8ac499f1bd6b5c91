#include "conformance/judge/calibrate_growth.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "conformance/growth/background_load.h"
#include "conformance/judge/grade.h"
#include "conformance/judge/toml_fields.h"
#include "conformance/sandbox/run_process.h"
#include "renderer/math/input_error.h"
#include "renderer/math/nearest_name.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 3> kDecisions{"pass", "fail", "undecided"};

GrowthDecision decision_named(std::string_view name) {
  return name == "pass" ? GrowthDecision::pass : name == "fail" ? GrowthDecision::fail : GrowthDecision::undecided;
}

/// One gate about one program: the cases that share it, with what each must say.
struct KnownGate {
  std::string subject;
  Suite suite;
  std::vector<GrowthDecision> expected;
  /// Gates that were run, with and without load.
  std::array<int, 2> done{};
  bool is_of(const CalibrationDecision& d) const { return d.subject == subject && d.gate == suite.cases.front().id; }
};

/// The cases that `subject` has expectations of, those that share their scenes together.
void add_gates(const CalibrationRequest& request, const fs::path& file, const std::string& subject,
               const toml::table& table, std::vector<KnownGate>& gates) {
  TomlFields fields(table, file, "[" + subject + "]");
  if (!fs::is_directory(request.subjects / subject))
    throw InputError({file.string()}, "[" + subject + "] is no folder of '" + request.subjects.string() + "'");
  const std::size_t first = gates.size();
  for (const SuiteCase& c : request.suite.cases) {
    if (c.kind != "growth" || !fields.has(c.id)) continue;
    const std::string name = fields.text(c.id);
    if (name != "pass" && name != "fail") fields.fail(c.id, "is '" + name + "', expected pass or fail");
    auto gate = std::find_if(gates.begin() + static_cast<std::ptrdiff_t>(first), gates.end(),
                             [&](const KnownGate& g) { return g.suite.cases.front().growth == c.growth; });
    if (gate == gates.end()) {
      gates.push_back({.subject = subject, .suite = request.suite, .expected = {}});
      gates.back().suite.cases.clear();
      gate = std::prev(gates.end());
    }
    gate->suite.cases.push_back(c);
    gate->suite.cases.back().prerequisites.clear();
    gate->expected.push_back(decision_named(name));
  }
  fields.finish();
}

std::vector<KnownGate> known_gates(const CalibrationRequest& request) {
  const fs::path file = request.subjects / "expected.toml";
  const toml::table table = read_toml(file);
  std::vector<KnownGate> gates;
  for (const auto& [key, node] : table) {
    if (!node.is_table()) throw InputError(location(file, node), "expected tables, [SUBMISSION]");
    add_gates(request, file, std::string(key.str()), *node.as_table(), gates);
  }
  if (gates.empty()) throw InputError({file.string()}, "holds no expectation about a case of the suite");
  return gates;
}

Json json_of(const CalibrationDecision& d) {
  return {{"subject", d.subject},
          {"gate", d.gate},
          {"loaded", d.loaded},
          {"expected", to_string(d.expected)},
          {"found", to_string(d.found)},
          {"verdict", d.verdict},
          {"cause", d.cause},
          {"slope", d.slope},
          {"seconds", d.seconds},
          {"attempts", d.attempts},
          {"seed", d.seed}};
}

std::vector<CalibrationDecision> read_record(const fs::path& file) {
  std::vector<CalibrationDecision> decisions;
  std::ifstream stream(file);
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    try {
      const Json json = Json::parse(line);
      CalibrationDecision d;
      d.subject = json.at("subject"), d.gate = json.at("gate"), d.loaded = json.at("loaded");
      d.expected = decision_named(json.at("expected").get<std::string>());
      d.found = decision_named(json.at("found").get<std::string>());
      d.verdict = json.at("verdict"), d.cause = json.at("cause"), d.slope = json.at("slope");
      d.seconds = json.at("seconds"), d.attempts = json.at("attempts"), d.seed = json.at("seed");
      decisions.push_back(std::move(d));
    } catch (const nlohmann::json::exception&) {
      throw InputError({file.string(), number, 1}, "is no line of a calibration's record");
    }
  }
  return decisions;
}

/// What a case says of its question; a wrong picture, a crash or a timeout says nothing of it, and is wrong whatever
/// was expected.
GrowthDecision found_in(const CaseResult& c, GrowthDecision expected) {
  if (is_right(c.check.verdict)) return GrowthDecision::pass;
  if (c.check.verdict == Verdict::internal_error) return GrowthDecision::undecided;
  if (c.check.cause == "not_sublinear" || c.check.cause == "slow_build") return GrowthDecision::fail;
  return expected == GrowthDecision::pass ? GrowthDecision::fail : GrowthDecision::pass;
}

double slope_in(const CaseResult& c, const SuiteCase& suite_case) {
  if (!c.growth) return 0;
  if (suite_case.measure == "build") return c.growth->building.slope.slope;
  double steepest = 0;
  for (const GrowthCurve& view : c.growth->views) steepest = std::max(steepest, view.slope.slope);
  return steepest;
}

std::vector<CalibrationDecision> run_gate(const CalibrationRequest& request, const KnownGate& gate, bool loaded) {
  GradeRequest grading;
  grading.submission = request.subjects / gate.subject;
  grading.suite = gate.suite;
  grading.out = request.record.parent_path() / "last-gate";
  grading.plumb_version = request.plumb_version;
  std::optional<BackgroundLoad> load;
  if (loaded) load.emplace(static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
  const ResultSet results = grade(grading);
  std::vector<CalibrationDecision> decisions;
  for (std::size_t i = 0; i < results.cases.size(); ++i) {
    const CaseResult& c = results.cases[i];
    CalibrationDecision d;
    d.subject = gate.subject, d.gate = c.id, d.loaded = loaded;
    d.expected = gate.expected[i];
    d.found = found_in(c, d.expected);
    d.verdict = to_string(c.check.verdict), d.cause = c.check.cause;
    d.slope = slope_in(c, gate.suite.cases[i]);
    if (c.growth) d.seconds = c.growth->wall_seconds, d.attempts = c.growth->attempts, d.seed = c.growth->seed;
    decisions.push_back(std::move(d));
  }
  return decisions;
}

void append(const fs::path& record, const std::vector<CalibrationDecision>& decisions) {
  std::ofstream stream(record, std::ios::app);
  for (const CalibrationDecision& d : decisions) stream << json_of(d).dump() << "\n";
  if (!stream.flush()) throw InputError({record.string()}, "cannot be written");
}

}  // namespace

std::vector<CalibrationDecision> calibrate_growth(const CalibrationRequest& request) {
  std::vector<KnownGate> gates = known_gates(request);
  std::vector<CalibrationDecision> decisions = read_record(request.record);
  int done = 0;
  for (KnownGate& gate : gates)
    for (const CalibrationDecision& d : decisions)
      if (gate.is_of(d)) ++gate.done[d.loaded], ++done;
  const auto total = [](const KnownGate& gate) { return gate.done[0] + gate.done[1]; };
  while (done < request.gates && !interrupt_flag()) {
    KnownGate& next = *std::ranges::min_element(gates, {}, total);
    const bool loaded = next.done[1] < next.done[0];
    request.progress(next.subject + " " + next.suite.cases.front().id + (loaded ? ", with load" : ""), done);
    const std::vector<CalibrationDecision> found = run_gate(request, next, loaded);
    if (interrupt_flag()) break;
    append(request.record, found);
    decisions.insert(decisions.end(), found.begin(), found.end());
    ++next.done[loaded], ++done;
  }
  return decisions;
}

}  // namespace plumb

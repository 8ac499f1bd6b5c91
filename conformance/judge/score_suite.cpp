#include "conformance/judge/score_suite.h"

#include <fnmatch.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "conformance/judge/grade_program.h"
#include "conformance/judge/score_pictures.h"
#include "conformance/judge/settle_mutant.h"
#include "conformance/judge/suite.h"
#include "renderer/film/tiles.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

const std::string kCheckPrefix = "check:";
/// Of processor time for one check, and on the clock: as `plumb check` gives the program in a folder.
constexpr double kCheckSeconds = 600, kCheckWallSeconds = 1800;

Suite built_suite(const fs::path& built) {
  Suite suite = read_suite(fs::is_directory(built) ? built / "suite.toml" : built);
  if (suite.needs_build() || suite.fingerprints.empty())
    throw InputError(
        {suite.file.string()},
        "holds no pictures of known mistakes, expected what 'plumb suite build' makes with the programs of "
        "'./dev mutants'");
  return suite;
}

/// In the order of the steps of the assignment.
std::vector<Mutant> selected_mutants(const fs::path& folder, const std::string& filter) {
  std::vector<Mutant> mutants = read_mutants(folder);
  std::erase_if(mutants,
                [&](const Mutant& m) { return !filter.empty() && ::fnmatch(filter.c_str(), m.id.c_str(), 0) != 0; });
  if (mutants.empty()) throw InputError({}, "--filter: no known mistake matches '" + filter + "'");
  std::ranges::stable_sort(mutants, {}, [](const Mutant& m) { return std::ranges::find(mutant_steps(), m.step); });
  return mutants;
}

ScoreCell cell_of(const CheckResult& result) {
  switch (result.verdict) {
    case Verdict::pass:
      return {.notice = Notice::right, .found = ""};
    case Verdict::quality_warning:
      return {.notice = Notice::warning, .found = result.summary};
    case Verdict::unsupported:
    case Verdict::skipped:
    case Verdict::internal_error:
      return {.notice = Notice::undecided, .found = result.summary};
    default:
      return {.notice = Notice::wrong, .found = result.summary};
  }
}

class SuiteScorer {
 public:
  explicit SuiteScorer(const SuiteScoreRequest& request)
      : request_(request),
        suite_(built_suite(request.built)),
        mutants_(selected_mutants(request.known_mistakes, request.filter)) {
    score_.suite_id = suite_.id, score_.suite_hash = suite_.hash, score_.plumb_version = request.plumb_version;
    score_.seed = request.seed, score_.intensity = request.intensity;
    for (const Mutant& m : mutants_) named_.insert(m.caught_by.begin(), m.caught_by.end());
    add_columns();
  }

  SuiteScore score() {
    require_programs_of_mutants();
    judge_pictures();
    ask_tracer();
    for (std::size_t i = 0; i < mutants_.size(); ++i) {
      request_.progress(mutants_[i].id, static_cast<double>(i + 1) / static_cast<double>(mutants_.size() + 1));
      ask_mutant(mutants_[i], score_.rows[i]);
    }
    count_noticed(score_);
    return std::move(score_);
  }

 private:
  /// Image cases with envelopes, growth cases, and the checks that mutants name.
  void add_columns() {
    for (SuiteCase& c : suite_.cases) {
      if (c.kind == "growth") c.growth.seed = request_.seed;
      if (c.kind == "growth" || !c.envelopes.empty()) add_column(c);
    }
    for (const std::string& name : named_) {
      if (!name.starts_with(kCheckPrefix)) continue;
      SuiteCase check;
      check.id = name, check.kind = "check", check.filter = name.substr(kCheckPrefix.size());
      check.intensity = request_.intensity, check.seed = request_.seed;
      check.cpu_seconds = kCheckSeconds, check.wall_seconds = kCheckWallSeconds;
      add_column(check);
    }
  }

  void add_column(const SuiteCase& c) {
    score_.columns.push_back({.id = c.id, .kind = c.kind, .fault = "", .only_here = {}});
    cases_.push_back(c);
  }

  bool has_to_run(const Mutant& m) const { return !m.accepted.empty() || !asked_of(m).empty(); }

  void require_programs_of_mutants() const {
    for (const Mutant& m : mutants_)
      if (has_to_run(m) && !fs::is_regular_file(request_.mutants / m.id))
        throw InputError({(request_.mutants / m.id).string()},
                         "this program with a known mistake does not exist, expected what './dev mutants' builds");
  }

  void judge_pictures() {
    std::map<std::string, Fingerprint> fingerprints;
    for (Fingerprint& f : read_fingerprints(suite_.fingerprints))
      if (f.parts.empty()) fingerprints.emplace(f.id, std::move(f));
    std::vector<std::optional<PictureScorer>> scorers(cases_.size());
    for (std::size_t i = 0; i < cases_.size(); ++i)
      if (cases_[i].kind == "image") scorers[i].emplace(cases_[i], suite_.variants);
    score_.rows.resize(mutants_.size());
    for_each_item(thread_count(0), static_cast<int>(mutants_.size()), [&](int, int item) {
      const Mutant& m = mutants_[static_cast<std::size_t>(item)];
      ScoreRow& row = score_.rows[static_cast<std::size_t>(item)];
      row.id = m.id, row.name = m.name, row.step = m.step, row.variant = m.accepted;
      const auto found = fingerprints.find(m.id);
      for (std::size_t i = 0; i < cases_.size(); ++i) {
        ScoreCell cell;
        if (scorers[i]) cell = scorers[i]->judge(found == fingerprints.end() ? Fingerprint() : found->second);
        cell.named = std::ranges::find(m.caught_by, cases_[i].id) != m.caught_by.end();
        row.cells.push_back(std::move(cell));
      }
    });
  }

  /// What the tracer without mistakes gets wrong is our own fault.
  void ask_tracer() {
    std::vector<SuiteCase> asked;
    for (const SuiteCase& c : cases_)
      if (c.kind == "image" || named_.contains(c.id)) asked.push_back(c);
    const auto results = grade_program(request_.tracer, suite_.variants, asked, [&](const std::string& what) {
      request_.progress("the tracer without mistakes: " + what, 0);
    });
    for (ScoreColumn& column : score_.columns)
      if (const auto found = results.find(column.id); found != results.end() && !is_right(found->second.verdict))
        column.fault = found->second.summary;
  }

  /// The checks and growth cases that a mutant names.
  std::vector<SuiteCase> asked_of(const Mutant& m) const {
    std::vector<SuiteCase> asked;
    for (const SuiteCase& c : cases_)
      if (c.kind != "image" && std::ranges::find(m.caught_by, c.id) != m.caught_by.end()) asked.push_back(c);
    return asked;
  }

  void ask_mutant(const Mutant& m, ScoreRow& row) const {
    const fs::path program = request_.mutants / m.id;
    const auto no_progress = [](const std::string&) {};
    for (const auto& [id, result] : grade_program(program, suite_.variants, asked_of(m), no_progress)) {
      const auto column = std::ranges::find(score_.columns, id, &ScoreColumn::id);
      ScoreCell& cell = row.cells[static_cast<std::size_t>(column - score_.columns.begin())];
      cell = cell_of(result);
      cell.named = true;
    }
    std::map<std::string, CheckResult> by_variant;
    if (!m.accepted.empty()) by_variant = graded_by_variant(program, m.accepted);
    settle_mutant(m, score_.columns, by_variant, row);
  }

  /// All image cases by one variant alone; nothing where the suite has no such variant.
  std::map<std::string, CheckResult> graded_by_variant(const fs::path& program, const std::string& variant) const {
    const auto found = std::ranges::find(suite_.variants, variant, &Variant::id);
    if (found == suite_.variants.end()) return {};
    const auto v = static_cast<std::size_t>(found - suite_.variants.begin());
    std::vector<SuiteCase> images;
    for (const SuiteCase& c : cases_) {
      if (c.kind != "image") continue;
      images.push_back(c);
      images.back().envelopes = {c.envelopes[v]};
      images.back().reference = c.envelopes[v] / "nominal.png";
    }
    return grade_program(program, {*found}, std::move(images), [](const std::string&) {});
  }

  const SuiteScoreRequest& request_;
  Suite suite_;
  std::vector<Mutant> mutants_;
  /// All that the mutants name.
  std::set<std::string> named_;
  /// One a column.
  std::vector<SuiteCase> cases_;
  SuiteScore score_;
};

}  // namespace

SuiteScore score_suite(const SuiteScoreRequest& request) { return SuiteScorer(request).score(); }

}  // namespace plumb

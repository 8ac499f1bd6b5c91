#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <set>

#include "conformance/checks/run_checks.h"
#include "conformance/judge/runner_rules.h"
#include "conformance/judge/suite.h"
#include "conformance/judge/suite_hash.h"
#include "conformance/judge/toml_fields.h"
#include "renderer/math/nearest_name.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// A pebibyte: far beyond any machine, and far from overflow.
constexpr std::int64_t kMostMegabytes = std::int64_t{1} << 30;

constexpr std::array<std::string_view, 3> kSkippedNames{"zero", "excluded", "manual"};
constexpr std::array<std::string_view, 4> kVisibilities{"visible", "hidden", "after_due_date", "after_published"};
constexpr std::array<std::string_view, 3> kKinds{"image", "check", "growth"};
constexpr std::array<std::string_view, 2> kMeasures{"trace", "build"};
constexpr std::array<std::string_view, 3> kSampleRoundings{"nearest", "up", "down"};
constexpr std::array<std::string_view, 5> kMeshFormats{"msh", "obj", "ply", "off", "stl"};

/// Ids name folders of the results, so they are plain file names.
bool is_plain_name(std::string_view name) {
  return !name.empty() && name.size() <= 100 && name.front() != '.' && name.front() != '-' &&
         std::ranges::all_of(name, [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '-' ||
                  c == '_';
         });
}

std::string plain_name(TomlFields& fields, std::string_view key) {
  const std::string name = fields.text(key);
  if (!is_plain_name(name))
    fields.fail(
        key, "is '" + name + "', expected a name of letters, digits, '-', '_' and '.', not beginning with '.' or '-'");
  return name;
}

std::string one_of(TomlFields& fields, std::string_view key, std::string_view otherwise,
                   std::span<const std::string_view> names) {
  const std::string value = fields.text(key, otherwise);
  if (std::ranges::find(names, value) == names.end()) {
    std::string expected;
    for (const std::string_view name : names) expected += (expected.empty() ? "" : ", ") + std::string(name);
    fields.fail(key, "is '" + value + "', expected " + expected + did_you_mean(value, names));
  }
  return value;
}

class SuiteReader {
 public:
  explicit SuiteReader(const fs::path& file) : table_(read_toml(file)), folder_(fs::absolute(file).parent_path()) {
    suite_.file = file;
  }

  Suite read() {
    check_top_level_keys();
    TomlFields top(table_, suite_.file, "the suite");
    read_suite_table(table_of(top, "suite"));
    read_variants();
    if (top.has("runner")) read_runner_table(table_of(top, "runner"));
    if (!suite_.has_runner && !suite_.own_runner)
      top.fail("runner", "is missing, expected a table with 'render', or own_runner = true in [suite]");
    read_cases(top);
    check_overlay();
    suite_.hash = suite_hash(suite_);
    return std::move(suite_);
  }

 private:
  const toml::table& table_of(TomlFields& top, std::string_view key) const {
    const toml::table* table = table_.get_as<toml::table>(key);
    if (!table) top.fail(key, "is missing, expected a table [" + std::string(key) + "]");
    return *table;
  }

  void read_suite_table(const toml::table& table) {
    TomlFields fields(table, suite_.file, "[suite]");
    suite_.id = plain_name(fields, "id");
    if (fields.integer("schema", 0, 0, 1000) != 1) fields.fail("schema", "must be 1, the version of this format");
    suite_.dialect = fields.text("dialect", "");
    suite_.undecidable_limit = fields.number("undecidable_limit", suite_.undecidable_limit, 0);
    if (fields.has("fingerprints"))
      suite_.fingerprints = existing_folder(fields, "fingerprints", fields.text("fingerprints"));
    suite_.total_seconds = fields.number("total_seconds", suite_.total_seconds, 1);
    suite_.own_runner = fields.flag("own_runner", false);
    const std::string skipped = one_of(fields, "skipped", "zero", kSkippedNames);
    suite_.skipped = static_cast<SkippedPolicy>(std::ranges::find(kSkippedNames, skipped) - kSkippedNames.begin());
    fields.finish();
  }

  /// Without any, the course's own reading is the one that is accepted.
  void read_variants() {
    const toml::array* variants = table_.get_as<toml::array>("variant");
    if (!variants) {
      suite_.variants = {Variant()};
      return;
    }
    for (const toml::node& node : *variants) {
      if (!node.is_table()) throw InputError(location(suite_.file, node), "expected a table [[variant]]");
      TomlFields fields(*node.as_table(), suite_.file, "[[variant]]");
      Variant v;
      v.id = plain_name(fields, "id");
      if (std::ranges::any_of(suite_.variants, [&](const Variant& other) { return other.id == v.id; }))
        fields.fail("id", "is '" + v.id + "', which an earlier variant has");
      const std::string samples = one_of(fields, "samples", "nearest", kSampleRoundings);
      v.samples = static_cast<SampleRounding>(std::ranges::find(kSampleRoundings, samples) - kSampleRoundings.begin());
      v.cutoff = fields.flag("cutoff", true);
      const std::string fresnel = one_of(fields, "fresnel", "exact", fresnel_names());
      v.fresnel = static_cast<Fresnel>(std::ranges::find(fresnel_names(), fresnel) - fresnel_names().begin());
      fields.finish();
      suite_.variants.push_back(std::move(v));
    }
  }

  void read_runner_table(const toml::table& table) {
    TomlFields fields(table, suite_.file, "[runner]");
    // A suite whose submissions bring their own commands may still say where their root is and how long a build may
    // take.
    suite_.has_runner = fields.has("render") || fields.has("build") || !suite_.own_runner;
    if (suite_.has_runner) suite_.runner = read_runner_fields(fields);
    suite_.root_marker = fields.text("root_marker", "");
    if (!suite_.root_marker.empty()) require_inner_path(fields, "root_marker", suite_.root_marker);
    suite_.build_seconds = fields.number("build_seconds", suite_.build_seconds, 1);
    if (fields.has("overlay")) {
      const std::string overlay = fields.text("overlay");
      suite_.overlay = (folder_ / overlay).lexically_normal();
      if (overlay.empty() || !fs::is_directory(suite_.overlay))
        fields.fail("overlay", "names a folder that does not exist: '" + suite_.overlay.string() + "'");
    }
    fields.finish();
  }

  void read_cases(TomlFields& top) {
    const toml::array* cases = table_.get_as<toml::array>("case");
    if (!cases || cases->empty()) top.fail("case", "is missing, expected at least one [[case]]");
    std::vector<std::vector<std::string>> requires_ids;
    for (const toml::node& node : *cases) {
      if (!node.is_table()) throw InputError(location(suite_.file, node), "expected a table [[case]]");
      requires_ids.push_back(read_case(*node.as_table()));
    }
    std::vector<std::string_view> ids;
    for (const SuiteCase& c : suite_.cases) ids.push_back(c.id);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      for (const std::string& id : requires_ids[i]) {
        const auto found = std::ranges::find(ids, id);
        const SourceLocation where = location(suite_.file, *cases->get(i));
        if (found == ids.end())
          throw InputError(where, "case '" + suite_.cases[i].id + "' requires '" + id +
                                      "', which is no case of this suite" + did_you_mean(id, ids));
        suite_.cases[i].prerequisites.push_back(static_cast<std::size_t>(found - ids.begin()));
      }
    }
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (reaches(i, i))
        throw InputError(location(suite_.file, *cases->get(i)),
                         "case '" + suite_.cases[i].id + "' requires itself, directly or through others");
    }
  }

  /// Whether the prerequisites of `from`, followed on, come to `to`.
  bool reaches(std::size_t from, std::size_t to) const {
    std::set<std::size_t> seen;
    std::vector<std::size_t> open = suite_.cases[from].prerequisites;
    while (!open.empty()) {
      const std::size_t next = open.back();
      open.pop_back();
      if (next == to) return true;
      if (seen.insert(next).second)
        open.insert(open.end(), suite_.cases[next].prerequisites.begin(), suite_.cases[next].prerequisites.end());
    }
    return false;
  }

  std::vector<std::string> read_case(const toml::table& table) {
    TomlFields fields(table, suite_.file, "[[case]]");
    SuiteCase c;
    c.id = plain_name(fields, "id");
    if (std::ranges::any_of(suite_.cases, [&](const SuiteCase& other) { return other.id == c.id; }))
      fields.fail("id", "is '" + c.id + "', which an earlier case has");
    c.kind = one_of(fields, "kind", "image", kKinds);
    if (c.kind == "check")
      read_check(fields, c);
    else if (c.kind == "growth")
      read_growth(fields, c);
    else
      read_image(fields, c);
    c.requirement = fields.text("requirement", "");
    c.points = fields.number("points", c.points, 0);
    c.cpu_seconds = fields.number("cpu_seconds", c.cpu_seconds, 0.01);
    c.wall_seconds = fields.number("wall_seconds", 3 * c.cpu_seconds, 0.01);
    c.memory_mb = fields.integer("memory_mb", c.memory_mb, 1, kMostMegabytes);
    c.output_mb = fields.integer("output_mb", c.output_mb, 1, kMostMegabytes);
    c.visibility = one_of(fields, "visibility", c.visibility, kVisibilities);
    std::vector<std::string> requires_ids = fields.texts("requires");
    fields.finish();
    suite_.cases.push_back(std::move(c));
    return requires_ids;
  }

  void read_image(TomlFields& fields, SuiteCase& c) const {
    if (suite_.has_runner && suite_.runner.render.empty())
      fields.fail("kind", "is image, but [runner] has no 'render'");
    for (const std::string& input : fields.texts("inputs")) c.inputs.push_back(existing_file(fields, "inputs", input));
    c.scene = scene_file(fields, c.inputs);
    for (const std::string& name : fields.texts("envelopes"))
      c.envelopes.push_back(existing_folder(fields, "envelopes", name));
    if (!c.envelopes.empty()) {
      if (fields.has("reference")) fields.fail("reference", "stands beside 'envelopes', which hold their own");
      if (c.envelopes.size() != suite_.variants.size())
        fields.fail("envelopes", "names " + std::to_string(c.envelopes.size()) +
                                     " folders, expected one for each of the " +
                                     std::to_string(suite_.variants.size()) + " variants");
      c.reference = c.envelopes.front() / "nominal.png";
      if (!fs::is_regular_file(c.reference))
        fields.fail("envelopes", "names a folder without nominal.png: '" + c.envelopes.front().string() + "'");
    } else if (fields.has("reference")) {
      c.reference = existing_file(fields, "reference", fields.text("reference"));
    }
    // One 8-bit level, which is 1/255 of the linear range of an EXR.
    const bool linear = equal_ignoring_case(c.reference.extension().string(), ".exr");
    c.tolerance = fields.number("tolerance", linear ? 1.0 / 255 : 1, 0);
    check_inputs(fields, c);
  }

  void read_check(TomlFields& fields, SuiteCase& c) const {
    if (suite_.has_runner && suite_.runner.probe.empty() && suite_.runner.kernel.empty())
      fields.fail("kind", "is check, but [runner] has neither 'probe' nor 'kernel'");
    c.filter = fields.text("filter", "");
    try {
      selected_checks(c.filter);
    } catch (const InputError& error) {
      fields.fail("filter", error.what());
    }
    c.intensity = fields.number("intensity", c.intensity, 0.001);
    c.seed = static_cast<std::uint64_t>(fields.integer("seed", 1, 0, std::numeric_limits<std::int64_t>::max()));
    c.cpu_seconds = 300;
  }

  void read_growth(TomlFields& fields, SuiteCase& c) const {
    if (suite_.has_runner && suite_.runner.render.empty())
      fields.fail("kind", "is growth, but [runner] has no 'render'");
    if (!fields.has("measure")) fields.fail("measure", "is missing, expected trace or build");
    c.measure = one_of(fields, "measure", "", kMeasures);
    GrowthScenes& g = c.growth;
    g.scene = c.scene = existing_file(fields, "scene", fields.text("scene"));
    g.reference_scene = fields.has("reference_scene")
                            ? existing_file(fields, "reference_scene", fields.text("reference_scene"))
                            : g.scene;
    g.object = fields.text("object", "");
    g.reference_object = fields.text("reference_object", g.object);
    g.mesh_format = one_of(fields, "mesh_format", g.mesh_format, kMeshFormats);
    check_template(fields, "scene", g.scene, !g.object.empty());
    check_template(fields, "reference_scene", g.reference_scene, !g.object.empty());
    // 64 times the smallest, which takes a gate far; the scene of many objects is long to read.
    g.largest = fields.number("largest", g.object.empty() ? 256'000 : 64'000, 64'000);
    g.tolerance = fields.number("tolerance", g.tolerance, 0);
    g.wrong_share = fields.number("wrong_share", g.wrong_share, 0);
    g.budget_seconds = fields.number("budget_seconds", g.budget_seconds, 1);
    if (fields.has("seed"))
      g.seed = static_cast<std::uint64_t>(fields.integer("seed", 1, 0, std::numeric_limits<std::int64_t>::max()));
    c.inputs = {g.scene};
    if (g.reference_scene != g.scene) c.inputs.push_back(g.reference_scene);
    c.cpu_seconds = 60;
  }

  /// A template that never says what is to grow would give every size the same scene.
  static void check_template(const TomlFields& fields, std::string_view key, const fs::path& file, bool of_objects) {
    std::ifstream stream(file);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    const std::string needed = of_objects ? "{objects}" : "{mesh}";
    if (text.find(needed) == std::string::npos)
      fields.fail(key, "names the template '" + file.string() + "', which does not hold " + needed);
  }

  /// Inputs lie beside the scene, so two of one name would overwrite each other.
  static void check_inputs(const TomlFields& fields, SuiteCase& c) {
    if (std::ranges::find(c.inputs, c.scene) == c.inputs.end()) c.inputs.push_back(c.scene);
    std::set<fs::path> names;
    for (const fs::path& input : c.inputs)
      if (!names.insert(input.filename()).second)
        fields.fail("inputs", "holds two files named '" + input.filename().string() + "'");
    if (!c.reference.empty() &&
        std::ranges::any_of(c.inputs, [&](const fs::path& input) { return fs::equivalent(input, c.reference); })) {
      fields.fail("inputs", "holds the reference, which the submission must not see");
    }
  }

  /// Staff files replace those of a submission, so each has to be a file that can be copied, and no reference.
  void check_overlay() const {
    if (suite_.overlay.empty()) return;
    for (const auto& entry : fs::recursive_directory_iterator(suite_.overlay)) {
      const SourceLocation where{suite_.file.string()};
      if (entry.is_symlink() || (!entry.is_regular_file() && !entry.is_directory()))
        throw InputError(where, "the overlay holds '" + entry.path().string() + "', which is no ordinary file");
      for (const SuiteCase& c : suite_.cases)
        if (entry.is_regular_file() && !c.reference.empty() && fs::equivalent(entry.path(), c.reference))
          throw InputError(where, "the overlay holds the reference '" + c.reference.string() +
                                      "', which the submission must not see");
    }
  }

  /// A path like any other, or the file name of one of the inputs.
  fs::path scene_file(TomlFields& fields, const std::vector<fs::path>& inputs) const {
    const std::string name = fields.text("scene");
    for (const fs::path& input : inputs)
      if (input.filename() == name) return input;
    return existing_file(fields, "scene", name);
  }

  fs::path existing_file(const TomlFields& fields, std::string_view key, const std::string& name) const {
    fs::path file = (folder_ / name).lexically_normal();
    if (!fs::is_regular_file(file)) fields.fail(key, "names a file that does not exist: '" + file.string() + "'");
    return file;
  }

  fs::path existing_folder(const TomlFields& fields, std::string_view key, const std::string& name) const {
    fs::path folder = (folder_ / name).lexically_normal();
    if (name.empty() || !fs::is_directory(folder))
      fields.fail(key, "names a folder that does not exist: '" + folder.string() + "'");
    return folder;
  }

  void check_top_level_keys() const {
    constexpr std::array<std::string_view, 4> kTables{"suite", "variant", "runner", "case"};
    for (const auto& [key, node] : table_) {
      if (std::ranges::find(kTables, key.str()) != kTables.end()) continue;
      throw InputError(location(suite_.file, node), "unknown key '" + std::string(key.str()) +
                                                        "', expected [suite], [[variant]], [runner] or [[case]]" +
                                                        did_you_mean(key.str(), kTables));
    }
  }

  toml::table table_;
  fs::path folder_;
  Suite suite_;
};

}  // namespace

bool Suite::needs_build() const {
  return std::ranges::any_of(cases, [](const SuiteCase& c) { return c.kind == "image" && c.reference.empty(); });
}

Suite read_suite(const fs::path& file) { return SuiteReader(file).read(); }

Runner read_submission_runner(const fs::path& file) {
  const toml::table table = read_toml(file);
  const toml::table* runner = table.get_as<toml::table>("runner");
  if (!runner) throw InputError({file.string()}, "[runner] is missing, expected a table with 'render'");
  for (const auto& [key, node] : table)
    if (key.str() != "runner")
      throw InputError(location(file, node), "unknown key '" + std::string(key.str()) +
                                                 "', expected [runner] alone: limits and points are the suite's");
  TomlFields fields(*runner, file, "[runner]");
  Runner result = read_runner_fields(fields);
  fields.finish();
  return result;
}

}  // namespace plumb

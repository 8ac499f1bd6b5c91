#include "conformance/judge/build_suite.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "conformance/envelopes/envelope_from_pictures.h"
#include "conformance/envelopes/jitter_camera.h"
#include "conformance/envelopes/make_envelope.h"
#include "conformance/judge/fingerprint_mutants.h"
#include "conformance/judge/suite.h"
#include "conformance/judge/suite_hash.h"
#include "conformance/judge/suite_manifest.h"
#include "conformance/judge/toml_fields.h"
#include "conformance/sandbox/run_process.h"
#include "renderer/build_scene.h"
#include "renderer/image/staged_file.h"
#include "renderer/kinds.h"
#include "renderer/math/input_error.h"
#include "scenes/dialect.h"
#include "scenes/read_scene.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// Copies a file into a folder of the suite that is made; returns its path there, as it stands in the suite.
std::string keep(const fs::path& file, const fs::path& root, const fs::path& folder) {
  fs::create_directories(root / folder);
  const fs::path kept = folder / file.filename();
  if (!fs::exists(root / kept)) fs::copy_file(file, root / kept);
  return kept.generic_string();
}

class SuiteBuilder {
 public:
  explicit SuiteBuilder(const SuiteBuildRequest& request)
      : request_(request), suite_(read_suite(request.suite)), table_(read_toml(request.suite)) {
    root_ = request.out.string() + ".partial";
  }
  /// What was not finished is not kept.
  ~SuiteBuilder() {
    std::error_code ignored;
    fs::remove_all(root_, ignored);
  }
  SuiteBuilder(const SuiteBuilder&) = delete;
  SuiteBuilder& operator=(const SuiteBuilder&) = delete;

  BuiltSuite build() {
    require_replaceable_suite(request_.out);
    if (!request_.mutants.empty()) require_mutants(request_.mutants, request_.known_mistakes);
    fs::remove_all(root_);
    fs::create_directories(root_);
    keep_overlay();
    add_cases();
    add_fingerprints();
    std::ostringstream text;
    text << table_ << "\n";
    write_file_staged(root_ / "suite.toml", text.str());
    write_manifest(root_, {.suite = suite_.id, .version = request_.plumb_version, .seed = seed()});
    fs::remove_all(request_.out);
    fs::rename(root_, request_.out);
    return std::move(built_);
  }

 private:
  std::optional<std::uint64_t> seed() const {
    return request_.jitters > 0 ? std::optional(request_.seed) : std::nullopt;
  }

  void keep_overlay() {
    if (suite_.overlay.empty()) return;
    fs::copy(suite_.overlay, root_ / "overlay", fs::copy_options::recursive);
    table_["runner"].as_table()->insert_or_assign("overlay", "overlay");
  }

  void add_cases() {
    toml::array cases;
    for (std::size_t i = 0; i < suite_.cases.size(); ++i) {
      if (interrupt_flag()) throw std::runtime_error("interrupted");
      const SuiteCase& c = suite_.cases[i];
      toml::table entry = *table_["case"][i].as_table();
      request_.progress(c.id, static_cast<double>(i) / static_cast<double>(suite_.cases.size()));
      if (c.kind == "growth") keep_growth(c, entry);
      if (c.kind != "image") {
        cases.push_back(std::move(entry));
        continue;
      }
      const bool has_envelopes = c.reference.empty();
      const int views = has_envelopes && request_.pictures.empty() ? request_.jitters : 0;
      entry.insert_or_assign("points", c.points / (views + 1));
      for (int view = 0; view <= views; ++view) {
        SuiteCase one = c;
        toml::table copy = entry;
        if (view > 0) move_camera(view, one, copy);
        keep_image(one, copy);
        if (has_envelopes) add_envelopes(one, copy);
        cases.push_back(std::move(copy));
        if (has_envelopes) images_.push_back(std::move(one));
      }
    }
    table_.insert_or_assign("case", std::move(cases));
  }

  void keep_growth(const SuiteCase& c, toml::table& entry) const {
    entry.insert_or_assign("scene", keep_template(c, c.growth.scene, "growth"));
    if (c.growth.reference_scene != c.growth.scene)
      entry.insert_or_assign("reference_scene", keep_template(c, c.growth.reference_scene, "growth/reference"));
  }

  /// Cases with the same template go on sharing it, and so one gate.
  std::string keep_template(const SuiteCase& c, const fs::path& file, const fs::path& folder) const {
    const fs::path shared = root_ / folder / file.filename();
    const bool is_taken = fs::exists(shared) && file_hash(shared) != file_hash(file);
    return keep(file, root_, is_taken ? folder / c.id : folder);
  }

  void keep_image(SuiteCase& c, toml::table& entry) const {
    const fs::path folder = fs::path("cases") / c.id;
    toml::array inputs;
    for (fs::path& input : c.inputs) {
      const std::string kept = keep(input, root_, folder);
      if (input == c.scene) entry.insert_or_assign("scene", kept), c.scene = root_ / kept;
      input = root_ / kept;
      inputs.push_back(kept);
    }
    entry.insert_or_assign("inputs", std::move(inputs));
    if (!c.reference.empty()) entry.insert_or_assign("reference", keep(c.reference, root_, folder / "reference"));
  }

  /// The same scene from another place, as a file of its own.
  void move_camera(int view, SuiteCase& c, toml::table& entry) const {
    const SceneDescription description = described(c.scene);
    std::vector<std::string> warnings;
    const Scene scene = build_scene(description, load_meshes(description), {}, warnings);
    c.id += fmt::format(".view{}", view);
    const fs::path file = root_ / "cases" / c.id / c.scene.filename();
    fs::create_directories(file.parent_path());
    write_file_staged(file, scene_with_camera(c.scene, jittered_camera(description, scene, request_.seed, view)));
    std::ranges::replace(c.inputs, c.scene, file);
    c.scene = file;
    entry.insert_or_assign("id", c.id);
    entry.insert_or_assign("requirement", c.requirement + fmt::format(" (another view, {})", view));
  }

  SceneDescription described(const fs::path& scene) const {
    return read_scene(scene, renderer_kinds(dialect_named(suite_.dialect.empty() ? "pa3-2011" : suite_.dialect)));
  }

  void add_envelopes(SuiteCase& c, toml::table& entry) {
    std::vector<std::string> folders;
    BuiltCase built{.id = c.id, .undecidable_share = 0, .guessed = !request_.pictures.empty()};
    const auto add = [&](const Envelope& envelope, const std::string& variant) {
      built.undecidable_share = std::max(built.undecidable_share, envelope.undecidable_share());
      folders.push_back((fs::path("envelopes") / c.id / variant).generic_string());
      write_envelope(envelope, root_ / folders.back());
    };
    if (built.guessed) {
      add(envelope_from_pictures(request_.pictures / c.id), "pictures");
      folders.resize(suite_.variants.size(), folders.front());
    } else {
      const SceneDescription description = described(c.scene);
      const MeshTable meshes = load_meshes(description);
      for (std::size_t v = 0; v < suite_.variants.size(); ++v) {
        const auto same = std::ranges::find_if(
            suite_.variants, [&](const Variant& other) { return same_for(description, other, suite_.variants[v]); });
        const auto first = static_cast<std::size_t>(same - suite_.variants.begin());
        if (first < v)
          folders.push_back(folders[first]);
        else
          add(make_envelope({.description = description, .meshes = meshes, .variant = suite_.variants[v]}),
              suite_.variants[v].id);
      }
    }
    require_decidable(built);
    built_.cases.push_back(built);
    toml::array list;
    for (const std::string& folder : folders) {
      list.push_back(folder);
      c.envelopes.push_back(root_ / folder);
    }
    c.reference = c.envelopes.front() / "nominal.png";
    entry.insert_or_assign("envelopes", std::move(list));
  }

  void require_decidable(const BuiltCase& c) const {
    if (c.undecidable_share <= suite_.undecidable_limit) return;
    throw InputError(
        {suite_.file.string()},
        fmt::format("case '{}': a correct program may answer differently at {:.2f} % of the pixels, more than the "
                    "limit of {:g} % ('undecidable_limit'); expected larger shapes, smoother meshes, or less of "
                    "reflections in reflections",
                    c.id, 100 * c.undecidable_share, 100 * suite_.undecidable_limit));
  }

  void add_fingerprints() {
    if (request_.mutants.empty()) return;
    built_.fingerprints = fingerprint_mutants({.programs = request_.mutants,
                                               .known_mistakes = request_.known_mistakes,
                                               .cases = images_,
                                               .out = root_ / "fingerprints",
                                               .progress = request_.progress});
    table_["suite"].as_table()->insert_or_assign("fingerprints", "fingerprints");
  }

  const SuiteBuildRequest& request_;
  Suite suite_;
  toml::table table_;
  fs::path root_;
  std::vector<SuiteCase> images_;
  BuiltSuite built_;
};

}  // namespace

BuiltSuite build_suite(const SuiteBuildRequest& request) { return SuiteBuilder(request).build(); }

}  // namespace plumb

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "conformance/envelopes/variant.h"

namespace plumb {

/// How a submission is built and run. Commands are argument lists; no shell reads them. In them stand for something:
/// `{width}` and `{height}` (render only): of the picture that is asked for;
/// `{sources:GLOB}` (build only, a whole argument): the matching files of the submission, by name;
/// `{scene}` the scene's path and `{folder}` its folder, relative to where the program runs; `{scene_name}` its file
/// name;
/// `{output}` the path of the picture.
struct Runner {
  std::vector<std::vector<std::string>> build;
  std::vector<std::string> render;
  std::vector<std::pair<std::string, std::string>> env;
  /// Where the picture appears, relative to where the program runs; may hold {scene}, {scene_name}, {folder}.
  std::string output = "{scene}.png";
  /// The folder that holds the scene and its inputs, relative to where the program runs; empty for that folder itself.
  std::string scene_at;
  /// The command of a probe (docs/probe-protocol.md), or the path of a kernel's shared library in the built submission;
  /// for cases of kind check. At most one.
  std::vector<std::string> probe;
  std::string kernel;
};

/// What a skipped case counts: no points, not at all, or as a person decides.
enum class SkippedPolicy { zero, excluded, manual };

/// kind growth: what the scenes of the growth gate are made from (docs/growth-gate.md). Cases that are equal in all of
/// it share one gate.
struct GrowthScenes {
  /// A template of the subject's scene, absolute; `SuiteCase::scene` holds the same file.
  std::filesystem::path scene;
  /// A template in our own dialect, for the reference; the scene itself where that is in it.
  std::filesystem::path reference_scene;
  /// A template of one object, in the subject's dialect and in ours; both empty where the scene is one mesh.
  std::string object, reference_object;
  /// The ending of the mesh file: `msh`, `obj`, `ply`, `off`, `stl`.
  std::string mesh_format = "msh";
  /// The largest scene has at least so many triangles or objects.
  double largest = 0;
  double tolerance = 3;
  double wrong_share = 0.02;
  double budget_seconds = 300;
  /// None: another one each time, so that nothing can be prepared.
  std::optional<std::uint64_t> seed;
  friend bool operator==(const GrowthScenes&, const GrowthScenes&) = default;
};

/// One thing that is asked of a submission: input files, a command (the runner's) and a reference picture.
struct SuiteCase {
  std::string id;
  std::string kind;
  /// kind check: which checks (their ids, as `plumb check --filter` takes them), how much and from which seed.
  std::string filter;
  double intensity = 1;
  std::uint64_t seed = 1;
  /// kind growth: which of the gate's two decisions, `trace` or `build`.
  std::string measure;
  GrowthScenes growth;
  /// kind image, as the rest. Copied beside the scene; absolute. The scene is among them.
  std::vector<std::filesystem::path> inputs;
  std::filesystem::path scene;
  std::filesystem::path reference;
  /// The folders of its envelopes, one a variant of the suite (docs/envelopes.md); `reference` is the first one's
  /// picture. Empty where the picture is judged by the reference and the tolerance alone.
  std::vector<std::filesystem::path> envelopes;
  /// The requirement it stands for, in words.
  std::string requirement;
  double points = 1;
  /// Places in Suite::cases.
  std::vector<std::size_t> prerequisites;
  /// The largest channel difference that is right: levels, or linear for EXR (where the default is 1/255).
  double tolerance = 1;
  double cpu_seconds = 30;
  double wall_seconds = 90;
  std::int64_t memory_mb = 2048;
  std::int64_t output_mb = 64;
  /// For hosts that show results to students: visible, hidden, after_due_date or after_published.
  std::string visibility = "visible";
};

/// A suite file: everything that decides.
struct Suite {
  std::filesystem::path file;
  std::string id;
  /// For people and reports; judging a picture reads no scene.
  std::string dialect;
  /// The accepted ways to read the assignment; at least one. A submission must keep to one in all cases.
  std::vector<Variant> variants;
  /// A scene of which more than this share of the pixels is undecidable is refused when the suite is built.
  double undecidable_limit = 0.05;
  /// The folder of the known mistakes' pictures; empty for none.
  std::filesystem::path fingerprints;
  /// On the clock, for all of a submission.
  double total_seconds = 3600;
  /// Whether the submission's own submission.toml says how it is built and run.
  bool own_runner = false;
  SkippedPolicy skipped = SkippedPolicy::zero;
  /// Whether the suite itself says how.
  bool has_runner = false;
  Runner runner;
  double build_seconds = 120;
  /// A file that every submission has: its root is the folder this path starts from. Empty: the folder that is handed
  /// in.
  std::string root_marker;
  /// A folder of staff files that replace those of the submission, absolute; empty for none.
  std::filesystem::path overlay;
  std::vector<SuiteCase> cases;
  /// SHA-256 over the suite file and every file it names.
  std::string hash;

  /// Whether a case of kind image has neither a reference nor envelopes: `plumb suite build` makes them.
  bool needs_build() const;
};

/// Reads and checks a suite. Paths in it are relative to its folder. Throws InputError, with line and column, for
/// malformed TOML, an unknown, missing or unusable value, two cases of one id, a prerequisite that does not exist or
/// depends on the case itself, and any file or folder that is missing: a missing reference fails here, never later.
Suite read_suite(const std::filesystem::path& file);

/// Reads the [runner] of a submission: build, render, env, output and scene_at, nothing that limits or decides. Throws
/// InputError.
Runner read_submission_runner(const std::filesystem::path& file);

}  // namespace plumb

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "conformance/families/random.h"
#include "conformance/growth/growth_gate.h"
#include "conformance/growth/growth_scene.h"
#include "conformance/judge/suite.h"
#include "conformance/judge/workspace.h"
#include "conformance/sandbox/run_outcome.h"

namespace plumb {

/// The runs of one growth gate: makes the scenes, runs the program on them, checks its pictures.
class GrowthRunner {
 public:
  /// The last three must outlive this. Writes the meshes of all sizes below the system's folder for temporary files.
  GrowthRunner(const SuiteCase& suite_case, std::uint64_t seed, const Runner& runner, Workspace& workspace);
  ~GrowthRunner();
  GrowthRunner(const GrowthRunner&) = delete;
  GrowthRunner& operator=(const GrowthRunner&) = delete;

  /// How many triangles or objects the scenes have.
  const std::vector<double>& sizes() const { return sizes_; }
  /// One run. Throws GrowthStop.
  GrowthAnswer run(const GrowthQuestion& question);
  /// Of the last run, whatever became of it.
  const std::string& log() const { return log_; }

 private:
  bool of_objects() const { return !suite_case_.growth.object.empty(); }
  void make_meshes();
  std::string objects(const GrowthQuestion& question, const std::string& object_template) const;
  GrowthNames names_of(const GrowthQuestion& question, const std::string& mesh,
                       const std::string& object_template) const;
  void write_scene(const std::filesystem::path& file, const std::filesystem::path& from,
                   const GrowthNames& names) const;
  std::string random_name();
  void check_picture(const GrowthQuestion& question, const RunOutcome& run, const std::filesystem::path& run_folder,
                     const std::string& output);

  const SuiteCase& suite_case_;
  const Runner& runner_;
  Workspace& workspace_;
  std::uint64_t seed_;
  Random names_;
  std::filesystem::path folder_;
  std::vector<double> sizes_;
  /// By size; behind them, that of the scene with next to nothing in it.
  std::vector<std::filesystem::path> meshes_;
  std::string log_;
};

}  // namespace plumb

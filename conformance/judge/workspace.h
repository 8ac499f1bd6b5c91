#pragma once

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "conformance/judge/commands.h"
#include "conformance/judge/copy_tree.h"
#include "conformance/judge/suite.h"

namespace plumb {

/// Thrown where a submission has destroyed even the copy that its build could be put back from.
class LostBuild : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The folders that one submission is built and run in, below the system's folder for temporary files; removed with
/// this object. References and results are never in them.
class Workspace {
 public:
  Workspace();
  ~Workspace();
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  /// Copies the submission: from the folder that the suite's root_marker starts from (the first, nearest to the top),
  /// with the overlay's files over it. Throws InputError if the root is not found or the submission is too large
  /// (copy_tree).
  void copy_submission(const std::filesystem::path& submission, const Suite& suite);
  const LeftOut& left_out() const { return left_out_; }
  /// Where the root marker was found, relative to what was handed in; the first is the root. Empty without a marker.
  const std::vector<std::string>& roots() const { return roots_; }

  /// The copy, in which the build runs.
  const std::filesystem::path& build() const { return build_; }

  /// Takes the write permissions from the build and remembers its state.
  void seal_build();
  /// Whether the build is as it was sealed. If not, it is put back. Throws LostBuild where that is no longer possible.
  bool check_build();

  /// A new folder for a case, with the inputs at the runner's scene_at and beside them links to what was built, but no
  /// picture.
  struct CaseFolder {
    std::filesystem::path all;   ///< whose size is watched
    std::filesystem::path run;   ///< where the program starts
    std::filesystem::path home;  ///< HOME and TMPDIR
  };
  CaseFolder make_case_folder(const SuiteCase& suite_case, const Runner& runner);
  /// So that no case can leave anything for a later one.
  void remove_case_folder(const CaseFolder& folder);

 private:
  /// What a file of the build is known by: size, the time it was last changed in any way (ctime, which no program can
  /// set), permissions; the target of a link.
  using State = std::map<std::string, std::string>;
  State state_of(const std::filesystem::path& folder) const;

  std::filesystem::path root_;
  std::filesystem::path sealed_root_;
  std::filesystem::path build_;
  std::filesystem::path sealed_copy_;
  State sealed_;
  LeftOut left_out_;
  std::vector<std::string> roots_;
};

/// The folders from which `marker` is found: `top` itself, or all of those nearest below it, by name. Hidden folders
/// are passed over. Throws InputError if there is none.
std::vector<std::filesystem::path> find_roots(const std::filesystem::path& top, const std::string& marker);

}  // namespace plumb

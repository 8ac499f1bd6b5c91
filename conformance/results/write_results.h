#pragma once

#include <filesystem>

#include "conformance/results/result_set.h"

namespace plumb {

/// The whole set as JSON text: results.json, with each case as its case.json has it.
std::string results_text(const ResultSet& results);

/// The folder that results go to. They are gathered in a new folder beside it, `DIR.partial-` and six letters, which
/// takes DIR's name at the end, so that DIR always holds a whole set.
class ResultFolder {
 public:
  /// Throws InputError if DIR is there and is no result set (it would be replaced), or the folder beside it cannot be
  /// made.
  ResultFolder(std::filesystem::path dir, std::string plumb_version);
  /// A folder in which no case was judged goes; any other stays for whoever looks for what was lost.
  ~ResultFolder();
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;

  /// Where files of a case belong beside its case.json; made on the way.
  std::filesystem::path case_folder(const std::string& id) const;
  std::filesystem::path build_folder() const;

  /// Writes case.json and usage.json of a case.
  void write_case(const CaseResult& result) const;
  /// Writes results.json and gives the folder its name, in place of an older set.
  void finish(const ResultSet& results) const;

  const std::filesystem::path& dir() const { return dir_; }

 private:
  std::filesystem::path dir_;
  std::filesystem::path partial_;
  std::string plumb_version_;
};

}  // namespace plumb

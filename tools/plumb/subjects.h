#pragma once

#include <memory>
#include <string>
#include <vector>

#include "conformance/subject/subject.h"

namespace plumb {

/// What a command line says of the thing under test.
struct SubjectArguments {
  /// `plumb`, a shipped kernel's name, a shared library, or a folder (with a suite).
  std::string subject;
  /// A suite whose [runner] says how the folder is built and started.
  std::string suite;
  /// A probe's command, in place of a subject.
  std::vector<std::string> probe;
};

/// A subject's doors, and how it is called.
struct OpenedSubject {
  std::string id;
  std::vector<std::unique_ptr<Subject>> doors;
  /// What keeps a built folder alive.
  std::shared_ptr<void> workspace;
  std::vector<Subject*> pointers() const;
};

/// Throws InputError for a name that is neither shipped nor a file (naming the nearest), a library that cannot be
/// loaded, a folder without a suite, and a build that fails.
OpenedSubject open_subject(const SubjectArguments& arguments);

}  // namespace plumb

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "conformance/subject/subject.h"

namespace plumb {

/// What a command line says of the thing under test, where it is no folder.
struct SubjectArguments {
  /// `plumb`, a shipped kernel's name, or a shared library.
  std::string subject;
  /// A probe's command, in place of a subject.
  std::vector<std::string> probe;
};

/// A subject's doors, and how it is called.
struct OpenedSubject {
  std::string id;
  std::vector<std::unique_ptr<Subject>> doors;
  std::vector<Subject*> pointers() const;
};

/// Throws InputError for a name that is neither shipped nor a file (naming the nearest), and a library that cannot be
/// loaded.
OpenedSubject open_subject(const SubjectArguments& arguments);

}  // namespace plumb

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

/// How a subject is called in results: its name, or that of its file without the folder. Throws InputError if none or
/// two are given.
std::string subject_id(const SubjectArguments& arguments);

/// A subject's doors.
struct OpenedSubject {
  std::vector<std::unique_ptr<Subject>> doors;
  std::vector<Subject*> pointers() const;
};

/// Throws InputError for a name that is neither shipped nor a file (naming the nearest), and a library that cannot be
/// loaded, and SubjectFailure if it fails where it should only start.
OpenedSubject open_subject(const SubjectArguments& arguments);

}  // namespace plumb

#include "tools/plumb/subjects.h"

#include <stdlib.h>

#include <algorithm>
#include <filesystem>

#include "conformance/subject/kernel_subject.h"
#include "conformance/subject/probe_subject.h"
#include "conformance/subject/shipped_kernels.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> own_environment() {
  std::vector<std::string> all;
  for (char** entry = environ; *entry; ++entry) all.emplace_back(*entry);
  return all;
}

std::unique_ptr<Subject> probe(std::vector<std::string> command) {
  return std::make_unique<ProbeSubject>(
      ProbeCommand{.arguments = std::move(command), .folder = fs::current_path(), .environment = own_environment()});
}

/// The tracer of ours has both doors: as a kernel it is given matrices and doubles, as a probe scenes.
OpenedSubject open_own() {
  OpenedSubject opened;
  opened.doors.push_back(std::make_unique<KernelSubject>(shipped_kernel("plumb")));
  opened.doors.push_back(probe({fs::read_symlink("/proc/self/exe").string(), "probe"}));
  return opened;
}

bool is_library(const fs::path& path) {
  return path.extension() == ".so" || path.filename().string().find(".so.") != std::string::npos;
}

}  // namespace

std::vector<Subject*> OpenedSubject::pointers() const {
  std::vector<Subject*> result;
  for (const auto& door : doors) result.push_back(door.get());
  return result;
}

std::string subject_id(const SubjectArguments& arguments) {
  if (arguments.subject.empty() && arguments.probe.empty())
    throw InputError(
        {}, "nothing to check, expected plumb, a shipped kernel, a .so, a folder with --suite, or --probe COMMAND");
  if (!arguments.subject.empty() && !arguments.probe.empty())
    throw InputError({}, "both a subject ('" + arguments.subject + "') and --probe are given, expected one of them");
  if (!arguments.probe.empty()) return fs::path(arguments.probe.front()).filename().string();
  return fs::path(arguments.subject).stem().string();
}

OpenedSubject open_subject(const SubjectArguments& arguments) {
  OpenedSubject opened;
  if (!arguments.probe.empty()) {
    opened.doors.push_back(probe(arguments.probe));
    return opened;
  }
  const std::string& subject = arguments.subject;
  if (subject == "plumb") return open_own();
  opened.doors.push_back(
      std::make_unique<KernelSubject>(is_library(subject) ? fs::path(subject) : shipped_kernel(subject)));
  return opened;
}

}  // namespace plumb

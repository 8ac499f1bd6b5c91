#include "tools/plumb/draw.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <ranges>
#include <stdexcept>

#include "conformance/sandbox/file_descriptor.h"
#include "conformance/sandbox/run_process.h"
#include "renderer/image/staged_file.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

FileDescriptor opened(const fs::path& file, int flags) {
  FileDescriptor descriptor(::open(file.c_str(), flags | O_CLOEXEC, 0666));
  if (!descriptor.valid()) throw InputError({file.string()}, "cannot open the file");
  return descriptor;
}

}  // namespace

fs::path gnuplot_program(const std::string& who) {
  const char* path = std::getenv("PATH");
  for (const auto range : std::views::split(std::string_view(path ? path : "/usr/bin:/bin"), ':')) {
    const fs::path program = fs::path(std::string(range.begin(), range.end())) / "gnuplot";
    if (program.is_absolute() && fs::is_regular_file(program) && ::access(program.c_str(), X_OK) == 0) return program;
  }
  throw InputError({}, who + " draws with gnuplot, which is not in the PATH; expected Debian's package gnuplot-nox");
}

/// The script goes in as standard input and the picture comes out as standard output: no name is ever part of a
/// command.
void draw(const fs::path& gnuplot, const fs::path& folder, const ReportFile& file) {
  const fs::path script = folder / file.name;
  write_file_staged(script, file.text);
  const fs::path picture = fs::path(script).replace_extension(".svg");
  fs::path partial = picture;
  partial += ".partial";
  ProcessRequest request;
  request.arguments = {gnuplot.string()};
  request.folder = fs::current_path();
  request.environment = {"LC_ALL=C.UTF-8", "HOME=/nonexistent"};
  request.limits = {.cpu_seconds = 60, .wall_seconds = 300};
  RunOutcome outcome;
  {
    const FileDescriptor input = opened(script, O_RDONLY);
    const FileDescriptor output = opened(partial, O_WRONLY | O_CREAT | O_TRUNC);
    request.input = input.get();
    request.output = output.get();
    outcome = run_process(request);
  }
  if (outcome.reason != StopReason::exited || outcome.exit_code != 0) {
    throw std::runtime_error("gnuplot cannot draw " + script.string() + ": " + to_string(outcome.reason) + " " +
                             outcome.start_error + outcome.log);
  }
  fs::rename(partial, picture);
}

}  // namespace plumb

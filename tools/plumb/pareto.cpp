#include "tools/plumb/pareto.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <ranges>
#include <stdexcept>

#include "conformance/pareto/contender.h"
#include "conformance/pareto/measure_pareto.h"
#include "conformance/sandbox/file_descriptor.h"
#include "conformance/sandbox/run_process.h"
#include "conformance/subject/shipped_kernels.h"
#include "renderer/image/staged_file.h"
#include "renderer/math/input_error.h"
#include "reports/pareto_csv.h"
#include "reports/pareto_plots.h"
#include "reports/pareto_text.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// HARD_CASES: on float inputs it is right nearly everywhere, at little cost, so no table may leave it out.
constexpr const char* kAlways = "mt-double";
constexpr const char* kScenes[] = {"antialiasing", "glass", "mesh-smooth"};

/// Beside the program that runs: `../share/plumb/scenes`.
std::vector<fs::path> shipped_scenes() {
  const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path().parent_path() / "share/plumb/scenes";
  std::vector<fs::path> scenes;
  for (const char* name : kScenes) scenes.push_back(folder / (std::string(name) + ".xml"));
  return scenes;
}

fs::path gnuplot_program() {
  const char* path = std::getenv("PATH");
  for (const auto range : std::views::split(std::string_view(path ? path : "/usr/bin:/bin"), ':')) {
    const fs::path program = fs::path(std::string(range.begin(), range.end())) / "gnuplot";
    if (program.is_absolute() && fs::is_regular_file(program) && ::access(program.c_str(), X_OK) == 0) return program;
  }
  throw InputError({}, "--pareto draws with gnuplot, which is not in the PATH; expected Debian's package gnuplot-nox");
}

FileDescriptor opened(const fs::path& file, int flags) {
  FileDescriptor descriptor(::open(file.c_str(), flags | O_CLOEXEC, 0666));
  if (!descriptor.valid()) throw InputError({file.string()}, "cannot open the file");
  return descriptor;
}

/// The script goes in as standard input and the picture comes out as standard output: no name is ever part of a
/// command.
void draw(const fs::path& gnuplot, const fs::path& script, const fs::path& picture) {
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

void require_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder))
    throw InputError({folder.string()}, "cannot make the folder for the figures: " + error.message());
  require_writable(folder / "class.csv");
}

void show_progress(const std::string& what, double share) {
  fmt::print(stderr, "\r\x1b[K{} {:.0f} % ...", what, 100 * share);
}

void write_figures(const ParetoResults& results, const fs::path& gnuplot, const fs::path& folder) {
  for (const ReportFile& file : pareto_csv(results)) write_file_staged(folder / file.name, file.text);
  write_file_staged(folder / "tables.txt", pareto_text(results));
  for (const ReportFile& file : pareto_plots(results)) {
    const fs::path script = folder / file.name;
    write_file_staged(script, file.text);
    draw(gnuplot, script, fs::path(script).replace_extension(".svg"));
  }
}

}  // namespace

int run_pareto(const ParetoArguments& arguments) {
  const fs::path gnuplot = gnuplot_program();
  const fs::path folder = arguments.out.empty() ? "plumb-results/pareto" : arguments.out;
  ParetoPlan plan;
  plan.kernels = selected_kernels(shipped_kernel_names(), arguments.filter, kAlways);
  plan.intensity = arguments.intensity;
  plan.seed = arguments.seed;
  plan.scenes = shipped_scenes();
  require_folder(folder);
  const bool on_terminal = ::isatty(STDERR_FILENO) == 1;
  if (on_terminal) plan.progress = show_progress;
  ParetoResults results = measure_pareto(plan);
  results.plumb_version = PLUMB_VERSION;
  if (on_terminal) fmt::print(stderr, "\r\x1b[K");
  fmt::print("{}", pareto_text(results));
  write_figures(results, gnuplot, folder);
  fmt::print("\nTables and plots: {}\n", folder.string());
  return results.notes.empty() ? 0 : 1;
}

}  // namespace plumb

#include "tools/plumb/pareto.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

#include "conformance/pareto/contender.h"
#include "conformance/pareto/measure_pareto.h"
#include "conformance/subject/shipped_kernels.h"
#include "renderer/image/staged_file.h"
#include "renderer/math/input_error.h"
#include "reports/pareto_csv.h"
#include "reports/pareto_plots.h"
#include "reports/pareto_text.h"
#include "tools/plumb/draw.h"

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
    draw(gnuplot, folder, file);
  }
}

}  // namespace

int run_pareto(const ParetoArguments& arguments) {
  const fs::path gnuplot = gnuplot_program("--pareto");
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

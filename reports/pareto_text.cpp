#include "reports/pareto_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace plumb {
namespace {

/// Rows of cells, each column as wide as its widest cell, the first aligned to the left and the others to the right.
class Grid {
 public:
  /// A line of its own, as wide as it likes.
  void title(const std::string& text) { rows_.push_back({text}); }
  void row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

  std::string text() const {
    std::vector<std::size_t> widths;
    for (const auto& cells : rows_) {
      if (cells.size() < 2) continue;
      widths.resize(std::max(widths.size(), cells.size()));
      for (std::size_t i = 0; i < cells.size(); ++i) widths[i] = std::max(widths[i], cells[i].size());
    }
    std::string text;
    for (const auto& cells : rows_) {
      for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells.size() == 1)
          text += cells[0];
        else if (i == 0)
          text += fmt::format("{:<{}}", cells[0], widths[0]);
        else
          text += fmt::format("  {:>{}}", cells[i], widths[i]);
      }
      text += "\n";
    }
    return text;
  }

 private:
  std::vector<std::vector<std::string>> rows_;
};

using Kernels = std::vector<const ParetoKernel*>;
constexpr const char* kNothing = "-";

/// A row: a cell of each kernel.
void row(Grid& grid, const std::string& name, const Kernels& kernels,
         const std::function<std::string(const ParetoKernel&)>& cell) {
  std::vector<std::string> cells{name};
  for (const ParetoKernel* kernel : kernels) cells.push_back(cell(*kernel));
  grid.row(std::move(cells));
}

/// Rows of one of the lists of figures, under a title: those that `matters` for a kernel; nothing where there are none.
template <class Figure>
void rows(
    Grid& grid, const std::string& title, const Kernels& kernels, std::vector<Figure> ParetoKernel::*list,
    const std::function<std::string(const Figure&)>& name, const std::function<std::string(const Figure&)>& cell,
    const std::function<bool(const Figure&)>& matters = [](const Figure&) { return true; }) {
  bool is_first = true;
  for (std::size_t i = 0; i < (kernels.front()->*list).size(); ++i) {
    const auto figure_of = [&](const ParetoKernel& kernel) -> const Figure& { return (kernel.*list)[i]; };
    if (std::ranges::none_of(kernels, [&](const ParetoKernel* kernel) { return matters(figure_of(*kernel)); }))
      continue;
    if (is_first) grid.title("\n" + title);
    is_first = false;
    row(grid, "  " + name(figure_of(*kernels.front())), kernels,
        [&](const ParetoKernel& kernel) { return figure_of(kernel).rays > 0 ? cell(figure_of(kernel)) : kNothing; });
  }
}

std::string number(double x) {
  return x >= 1e5 ? fmt::format("{:.1e}", x) : x >= 10 ? fmt::format("{:.0f}", x) : fmt::format("{:.2g}", x);
}
std::string whole(double x) { return x >= 10 ? fmt::format("{:.0f}", x) : number(x); }

void speed_rows(Grid& grid, const Kernels& kernels) {
  const auto of_speed = [&](const std::string& name, const std::function<std::string(const SpeedFigure&)>& cell) {
    row(grid, name, kernels,
        [&](const ParetoKernel& kernel) { return kernel.speed.rounds > 0 ? cell(kernel.speed) : kNothing; });
  };
  row(grid, "", kernels, [](const ParetoKernel& kernel) { return kernel.name; });
  of_speed("million rays/s", [](const SpeedFigure& s) { return fmt::format("{:.3g}", s.million_rays_a_second); });
  of_speed("  slowest round", [](const SpeedFigure& s) { return fmt::format("{:.3g}", s.slowest); });
  of_speed("  fastest round", [](const SpeedFigure& s) { return fmt::format("{:.3g}", s.fastest); });
}

void class_rows(Grid& grid, const Kernels& kernels, bool spheres) {
  const auto name = [](const ClassFigure& f) { return f.family + " " + f.name; };
  const auto rate = [](std::int64_t count, const ClassFigure& f) { return rate_text({count, f.rays}); };
  const auto& list = &ParetoKernel::classes;
  const std::string surface = spheres ? "sphere" : "triangle";
  rows<ClassFigure>(
      grid,
      "class against one " + surface + ": false misses/false hits" + (spheres ? "/wrong root" : "") + " per million",
      kernels, list, name, [&](const ClassFigure& f) {
        const std::string both = rate(f.false_misses, f) + "/" + rate(f.false_hits, f);
        return spheres ? both + "/" + rate(f.wrong_crossings, f) : both;
      });
  rows<ClassFigure>(
      grid, "  hits whose t is not finite, taken for misses, per million", kernels, list, name,
      [&](const ClassFigure& f) { return rate(f.not_finite, f); },
      [](const ClassFigure& f) { return f.not_finite > 0; });
  if (!spheres) {
    rows<ClassFigure>(grid, "  how far from an edge the farthest wrong ray passes, in u of the kernel", kernels, list,
                      name, [](const ClassFigure& f) { return f.wrong().count > 0 ? number(f.farthest_u) : "none"; });
  }
  rows<ClassFigure>(grid, "  t of the right hits off by ulp: median/99 %", kernels, list, name,
                    [](const ClassFigure& f) {
                      return f.right_hits > 0 ? number(f.t_ulps_median) + "/" + number(f.t_ulps_p99) : kNothing;
                    });
}

void mesh_rows(Grid& grid, const Kernels& kernels) {
  const auto aim = [](const EscapeFigure& f) { return "at " + f.aim; };
  rows<EscapeFigure>(grid, "escapes from closed meshes per million", kernels, &ParetoKernel::escapes, aim,
                     [](const EscapeFigure& f) { return rate_text(f.rate()); });
  rows<EscapeFigure>(
      grid, "  how far from an edge they pass, in u: median/farthest", kernels, &ParetoKernel::escapes, aim,
      [](const EscapeFigure& f) { return f.escapes > 0 ? number(f.median_u) + "/" + number(f.farthest_u) : "none"; });
  const auto mesh = [](const ClosestFigure& f) { return f.scene + " at " + f.aim; };
  const auto rate = [](std::int64_t count, const ClosestFigure& f) { return rate_text({count, f.rays}); };
  rows<ClosestFigure>(
      grid, "wrong closest triangle per million: missed/beside/behind", kernels, &ParetoKernel::closest, mesh,
      [&](const ClosestFigure& f) { return rate(f.missed, f) + "/" + rate(f.beside, f) + "/" + rate(f.behind, f); });
  rows<ClosestFigure>(grid, "  the farthest: beside the edge in u, behind the first in ulp", kernels,
                      &ParetoKernel::closest, mesh, [](const ClosestFigure& f) {
                        return f.wrong().count > 0 ? number(f.farthest_u) + ", " + number(f.farthest_ulps) : "none";
                      });
}

Kernels asked_with(const std::vector<ParetoKernel>& kernels, const std::string& inputs) {
  Kernels chosen;
  for (const ParetoKernel& kernel : kernels)
    if (kernel.inputs == inputs) chosen.push_back(&kernel);
  return chosen;
}

std::string kernel_tables(const std::vector<ParetoKernel>& all, bool spheres) {
  std::string text;
  for (const char* inputs : {"float", "double"}) {
    const Kernels kernels = asked_with(all, inputs);
    if (kernels.empty()) continue;
    text += fmt::format("\n{}, inputs of {}\n", spheres ? "Spheres" : "Triangles",
                        kernels.front()->inputs == "float" ? "24 bits (floats)" : "53 bits (doubles)");
    Grid grid;
    speed_rows(grid, kernels);
    class_rows(grid, kernels, spheres);
    if (!spheres) mesh_rows(grid, kernels);
    text += grid.text();
  }
  return text;
}

std::string picture_table(const std::vector<PictureFigure>& pictures) {
  if (pictures.empty()) return "";
  const PictureFigure& first = pictures.front();
  Grid grid;
  grid.row({"scene", "samples", "rms", "largest", "CPU s"});
  for (const PictureFigure& p : pictures)
    grid.row({p.scene, fmt::format("{}", p.samples), fmt::format("{:.4f}", p.rms), fmt::format("{:.3f}", p.largest),
              fmt::format("{:.4f}", p.cpu_seconds)});
  return fmt::format("\nPictures of {}x{}, plumb, one thread: difference from {} samples a pixel, linear colour\n",
                     first.width, first.height, first.reference_samples) +
         grid.text();
}

}  // namespace

std::string rate_text(const Rate& rate) {
  if (rate.of == 0) return kNothing;
  return rate.count > 0 ? whole(rate.per_million()) : "<" + whole(rate.bound_per_million());
}

std::string pareto_text(const ParetoResults& results) {
  std::string text = fmt::format("Speed against error: plumb {}, seed {}, intensity {:g}, {}\n", results.plumb_version,
                                 results.seed, results.intensity, results.processor);
  text += fmt::format("A ray costs {:.1f} ns of CPU time without any work on it ({:.0f} ns on the clock).\n",
                      results.empty_cpu_nanoseconds, results.empty_clock_nanoseconds);
  text +=
      "<x: none of N, so below x = 3/N per million at 95 %. Names with /53: inputs that use all bits of a double.\n";
  text += "Triangles for speed: " + results.triangle_scene + "; spheres: " + results.sphere_scene + ".\n\n";
  for (const std::vector<ParetoKernel>* list : {&results.triangles, &results.spheres})
    for (const ParetoKernel& kernel : *list)
      if (kernel.inputs == "float") text += fmt::format("{:<23} {}\n", kernel.name, kernel.description);
  text += kernel_tables(results.triangles, false);
  text += kernel_tables(results.spheres, true);
  text += picture_table(results.pictures);
  for (const std::string& note : results.notes) text += "note: " + note + "\n";
  return text;
}

}  // namespace plumb

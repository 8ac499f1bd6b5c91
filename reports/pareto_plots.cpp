#include "reports/pareto_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "reports/gnuplot_panels.h"

namespace plumb {
namespace {

constexpr const char* kSpeedTitle = "million rays per CPU second";

std::string without_bits(const std::string& name) { return name.substr(0, name.find('/')); }

/// A kernel keeps its colour, whatever it is asked with; circles are floats, triangles 53 bits.
std::vector<SeriesStyle> styles_of(const std::vector<ParetoKernel>& kernels) {
  std::vector<std::string> names;
  std::vector<SeriesStyle> styles;
  for (const ParetoKernel& kernel : kernels) {
    const std::string name = without_bits(kernel.name);
    const auto found = std::ranges::find(names, name);
    const auto color = static_cast<std::size_t>(found - names.begin());
    if (found == names.end()) names.push_back(name);
    styles.push_back({kernel.name, color, kernel.inputs == "double"});
  }
  return styles;
}

/// A panel for each figure of a list: its rate against the kernel's speed.
template <class Figure>
std::vector<ScatterPanel> panels_of(const std::vector<ParetoKernel>& kernels, std::vector<Figure> ParetoKernel::*list,
                                    const std::function<std::string(const Figure&)>& title,
                                    const std::function<Rate(const Figure&)>& rate_of) {
  std::vector<ScatterPanel> panels;
  for (std::size_t k = 0; k < kernels.size(); ++k) {
    const std::vector<Figure>& figures = kernels[k].*list;
    for (std::size_t i = 0; i < figures.size(); ++i) {
      if (panels.size() <= i) panels.push_back({title(figures[i]), {}});
      const Rate rate = rate_of(figures[i]);
      if (rate.of == 0 || kernels[k].speed.rounds == 0) continue;
      const bool none = rate.count == 0;
      panels[i].points.push_back(
          {k, kernels[k].speed.million_rays_a_second, none ? rate.bound_per_million() : rate.per_million(), none});
    }
  }
  return panels;
}

const std::vector<std::string>& remarks() {
  static const std::vector<std::string> lines{"circles: inputs are floats", "triangles: inputs use all 53 bits",
                                              "open: none of N, drawn at 3/N (95 %)", "better: right and below"};
  return lines;
}

std::string title_of(const ClassFigure& figure) { return figure.name + " (" + figure.family + ")"; }

std::string class_plot(const std::vector<ParetoKernel>& kernels, const std::string& title) {
  return scatter_script({title, kSpeedTitle, "wrong per million", remarks()}, styles_of(kernels),
                        panels_of<ClassFigure>(kernels, &ParetoKernel::classes, title_of,
                                               [](const ClassFigure& f) { return f.wrong(); }));
}

std::string escapes_plot(const std::vector<ParetoKernel>& kernels) {
  return scatter_script(
      {"Speed against rays that escape from closed meshes", kSpeedTitle, "escapes per million", remarks()},
      styles_of(kernels),
      panels_of<EscapeFigure>(
          kernels, &ParetoKernel::escapes, [](const EscapeFigure& f) { return "aimed at " + f.aim; },
          [](const EscapeFigure& f) { return f.rate(); }));
}

std::string closest_plot(const std::vector<ParetoKernel>& kernels) {
  return scatter_script(
      {"Speed against wrong closest triangles (exact ties apart)", kSpeedTitle, "wrong per million", remarks()},
      styles_of(kernels),
      panels_of<ClosestFigure>(
          kernels, &ParetoKernel::closest, [](const ClosestFigure& f) { return f.scene + ", at " + f.aim; },
          [](const ClosestFigure& f) { return f.wrong(); }));
}

std::string pictures_plot(const std::vector<PictureFigure>& pictures) {
  std::vector<SeriesStyle> styles;
  std::vector<LabelledLine> lines;
  for (const PictureFigure& picture : pictures) {
    if (styles.empty() || styles.back().name != picture.scene) {
      styles.push_back({picture.scene, styles.size(), false});
      lines.push_back({styles.size() - 1, {}, false});
    }
    // A logarithmic axis has no place for no difference at all.
    if (picture.rms > 0)
      lines.back().points.push_back({picture.cpu_seconds, picture.rms, fmt::format("{}", picture.samples)});
  }
  if (!lines.empty()) lines.back().labels_below = true;
  FigureText text{"Pictures: error against time", "CPU seconds", "RMS difference, linear colour", {}};
  if (!pictures.empty()) {
    const PictureFigure& first = pictures.front();
    text.remarks = {"numbers: samples a pixel", fmt::format("{} x {} pixels, one thread", first.width, first.height),
                    fmt::format("against {} samples a pixel", first.reference_samples)};
  }
  return lines_script(text, styles, lines);
}

}  // namespace

std::vector<ReportFile> pareto_plots(const ParetoResults& results) {
  return {{"class.gnuplot", class_plot(results.triangles, "Speed against the class of single triangles")},
          {"escapes.gnuplot", escapes_plot(results.triangles)},
          {"closest.gnuplot", closest_plot(results.triangles)},
          {"spheres.gnuplot", class_plot(results.spheres, "Speed against the class of single spheres")},
          {"pictures.gnuplot", pictures_plot(results.pictures)}};
}

}  // namespace plumb

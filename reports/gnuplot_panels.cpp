#include "reports/gnuplot_panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace plumb {
namespace {

/// Okabe and Ito's colours, which most colour-blind people tell apart.
constexpr std::array<const char*, 8> kColors{"#0072b2", "#d55e00", "#009e73", "#e69f00",
                                             "#cc79a7", "#56b4e9", "#000000", "#8c6d31"};

/// In pixels: a panel's frame, the room around it, and around the whole.
constexpr double kPanelWidth = 270, kPanelHeight = 210;
constexpr double kGapX = 24, kGapY = 52;
constexpr double kLeft = 92, kRight = 24, kTop = 70, kBottom = 66;
constexpr double kLegendLine = 21, kLegendWidth = 240;

const char* color_of(const SeriesStyle& style) { return kColors[style.color % kColors.size()]; }

int point_type(const SeriesStyle& style, bool open) { return style.triangles ? (open ? 8 : 9) : (open ? 6 : 7); }

/// The range of a logarithmic axis with room at both ends.
struct Range {
  double low = 0, high = 0;
  void extend(double x) {
    low = low == 0 ? x : std::min(low, x);
    high = std::max(high, x);
  }
  std::string text() const { return high > 0 ? fmt::format("[{}:{}]", low / 2, high * 2) : "[1:10]"; }
};

/// 0.01, 20, 1k, 1M
std::string tic_label(int digit, int power) {
  const double value = digit * std::pow(10.0, power);
  return power >= 6   ? fmt::format("{:g}M", value / 1e6)
         : power >= 3 ? fmt::format("{:g}k", value / 1e3)
                      : fmt::format("{:g}", value);
}

/// Powers of ten with their labels (or none); on a short axis 2 and 5 times these too.
std::string tics(const Range& range, bool with_labels) {
  constexpr double kShort = 30;
  const bool is_short = range.high < kShort * range.low;
  std::string text;
  for (int power = -9; power <= 9; ++power) {
    for (int digit = 1; digit <= 9; ++digit) {
      const bool is_named = digit == 1 || (is_short && (digit == 2 || digit == 5));
      text += fmt::format("{}'{}' {:g} {}", text.empty() ? "" : ", ",
                          is_named && with_labels ? tic_label(digit, power) : "", digit * std::pow(10.0, power),
                          is_named ? 0 : 1);
    }
  }
  return "(" + text + ")";
}

/// The commands for an axis, `x` or `y`.
std::string axis(char name, const Range& range, bool with_labels) {
  return fmt::format("set {0}range {1}\nset {0}tics nomirror {2}\n", name, range.text(), tics(range, with_labels));
}

/// Where things are, in pixels from the upper left; gnuplot counts in shares from the lower left.
class Canvas {
 public:
  Canvas(double width, double height) : width_(width), height_(height) {}

  std::string opening(const FigureText& text) const {
    std::string script = fmt::format(
        "set terminal svg size {:.0f},{:.0f} noenhanced font 'DejaVu Sans,Helvetica,Arial,sans-serif,12' "
        "background '#ffffff'\n",
        width_, height_);
    script += "set multiplot\nset logscale xy\nunset key\nset border 3 lc rgb '#555555'\n";
    script += "set grid xtics ytics lt 1 lw 0.5 lc rgb '#d8d8d8'\n";
    script += label(text.title, kLeft, 26, "font ',16'");
    return script;
  }
  std::string label(const std::string& text, double x, double y, const std::string& style = "") const {
    return fmt::format("set label {} at screen {} left {}\n", gnuplot_quoted(text), at(x, y), style);
  }
  std::string mark(const SeriesStyle& style, bool open, double x, double y) const {
    return fmt::format("set label '' at screen {} point pt {} ps 1.1 lw 1.5 lc rgb '{}'\n", at(x, y),
                       point_type(style, open), color_of(style));
  }
  std::string frame(double x, double y, double width, double height) const {
    return fmt::format(
        "set lmargin at screen {}\nset rmargin at screen {}\nset tmargin at screen {}\nset bmargin at screen {}\n",
        x / width_, (x + width) / width_, 1 - y / height_, 1 - (y + height) / height_);
  }
  std::string legend(const FigureText& text, const std::vector<SeriesStyle>& series, double x, double y) const {
    std::string script;
    for (const SeriesStyle& style : series) {
      script += mark(style, false, x + 6, y) + label(style.name, x + 22, y);
      y += kLegendLine;
    }
    y += 6;
    for (const std::string& remark : text.remarks) {
      script += label(remark, x, y, "font ',11' tc rgb '#444444'");
      y += kLegendLine - 4;
    }
    return script;
  }

 private:
  std::string at(double x, double y) const { return fmt::format("{},{}", x / width_, 1 - y / height_); }

  double width_, height_;
};

double legend_height(const FigureText& text, const std::vector<SeriesStyle>& series) {
  return kLegendLine * static_cast<double>(series.size()) +
         (kLegendLine - 4) * static_cast<double>(text.remarks.size());
}

std::string panel_plot(const ScatterPanel& panel, const std::vector<SeriesStyle>& series) {
  std::string data, plots;
  for (std::size_t i = 0; i < panel.points.size(); ++i) {
    const ScatterPoint& point = panel.points[i];
    const SeriesStyle& style = series.at(point.series);
    data += fmt::format("$p{} << end\n{} {}\nend\n", i, point.x, point.y);
    plots += fmt::format("{}$p{} with points pt {} ps 1.1 lw 1.5 lc rgb '{}'", plots.empty() ? "" : ", \\\n  ", i,
                         point_type(style, point.is_bound), color_of(style));
  }
  return data + "plot " + (plots.empty() ? "1/0" : plots) + "\n";
}

}  // namespace

std::string gnuplot_quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') quoted += '\'';
    quoted += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
  }
  return quoted + "'";
}

std::string scatter_script(const FigureText& text, const std::vector<SeriesStyle>& series,
                           const std::vector<ScatterPanel>& panels) {
  const std::size_t columns = panels.size() <= 3 ? std::max<std::size_t>(panels.size(), 1) : panels.size() <= 6 ? 3 : 4;
  const std::size_t rows = std::max<std::size_t>((panels.size() + columns - 1) / columns, 1);
  const auto left_of = [](std::size_t column) { return kLeft + static_cast<double>(column) * (kPanelWidth + kGapX); };
  const auto top_of = [](std::size_t row) { return kTop + static_cast<double>(row) * (kPanelHeight + kGapY); };
  const double height = std::max(top_of(rows) - kGapY, kTop + legend_height(text, series)) + kBottom;
  const Canvas canvas(left_of(columns) + kLegendWidth + kRight, height);
  Range x, y;
  for (const ScatterPanel& panel : panels) {
    for (const ScatterPoint& point : panel.points) x.extend(point.x), y.extend(point.y);
  }
  std::string script = canvas.opening(text) + axis('x', x, true);
  script += canvas.legend(text, series, left_of(columns), kTop + 6);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const std::size_t column = i % columns, row = i / columns;
    const bool is_lowest = i + columns >= panels.size();
    script += canvas.frame(left_of(column), top_of(row), kPanelWidth, kPanelHeight);
    script += canvas.label(panels[i].title, left_of(column), top_of(row) - 12, "font ',13'");
    script += is_lowest ? "set xlabel " + gnuplot_quoted(text.x_title) + "\n" : "unset xlabel\n";
    script += column == 0 ? "set ylabel " + gnuplot_quoted(text.y_title) + " offset -1,0\n" : "unset ylabel\n";
    script += axis('y', y, column == 0);
    script += panel_plot(panels[i], series);
    script += "unset label\n";
  }
  return script + "unset multiplot\n";
}

std::string lines_script(const FigureText& text, const std::vector<SeriesStyle>& series,
                         const std::vector<LabelledLine>& lines) {
  constexpr double kWidth = 620, kHeight = 420;
  const Canvas canvas(kLeft + kWidth + kGapX + kLegendWidth, kTop + kHeight + kBottom);
  Range x, y;
  std::string data, plots;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const char* color = color_of(series.at(lines[i].series));
    data += fmt::format("$line{} << end\n", i);
    for (const LabelledLine::Point& point : lines[i].points) {
      x.extend(point.x), y.extend(point.y);
      data += fmt::format("{} {} \"{}\"\n", point.x, point.y, point.label);
    }
    data += "end\n";
    plots += fmt::format(
        "{0}$line{1} using 1:2 with linespoints pt {4} ps 0.9 lw 1.5 lc rgb '{2}', \\\n"
        "  $line{1} using 1:2:3 with labels offset {3} font ',10' tc rgb '{2}'",
        plots.empty() ? "" : ", \\\n  ", i, color, lines[i].labels_below ? "-0.9,-0.8" : "0.9,0.8",
        point_type(series.at(lines[i].series), false));
  }
  std::string script = canvas.opening(text) + canvas.frame(kLeft, kTop, kWidth, kHeight);
  script += axis('x', x, true) + axis('y', y, true);
  script +=
      "set xlabel " + gnuplot_quoted(text.x_title) + "\nset ylabel " + gnuplot_quoted(text.y_title) + " offset -1,0\n";
  script += canvas.legend(text, series, kLeft + kWidth + kGapX, kTop + 10);
  return script + data + "plot " + (plots.empty() ? "1/0" : plots) + "\nunset multiplot\n";
}

}  // namespace plumb

#pragma once

#include <string>
#include <vector>

namespace plumb {

/// How a series looks: a colour by its number, and the form of its points.
struct SeriesStyle {
  std::string name;
  std::size_t color = 0;
  bool triangles = false;  ///< in place of circles
};

/// A point of a scatter, both coordinates > 0.
struct ScatterPoint {
  std::size_t series = 0;
  double x = 0, y = 0;
  /// Drawn open: y is a bound, not a measurement.
  bool is_bound = false;
};

struct ScatterPanel {
  std::string title;
  std::vector<ScatterPoint> points;
};

/// A line through points that each have a label.
struct LabelledLine {
  std::size_t series = 0;
  struct Point {
    double x = 0, y = 0;
    /// Without quotes; may be empty.
    std::string label;
  };
  std::vector<Point> points;
  /// To the left below the points in place of the right above.
  bool labels_below = false;
};

/// What a figure says around its panels.
struct FigureText {
  std::string title, x_title, y_title;
  /// Below the names in the legend, a line each.
  std::vector<std::string> remarks;
};

/// A script for gnuplot 5.4 that writes SVG to its standard output: panels beside and below each other with the same
/// logarithmic axes, and the legend at their right. Texts stand in it as they are, whatever they hold.
std::string scatter_script(const FigureText& text, const std::vector<SeriesStyle>& series,
                           const std::vector<ScatterPanel>& panels);

/// One panel of lines, with the legend at its right.
std::string lines_script(const FigureText& text, const std::vector<SeriesStyle>& series,
                         const std::vector<LabelledLine>& lines);

/// A text as gnuplot reads it in single quotes; control characters become spaces.
std::string gnuplot_quoted(const std::string& text);

}  // namespace plumb

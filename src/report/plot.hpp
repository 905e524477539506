#pragma once
#include <string>
#include <utility>
#include <vector>

namespace towform {

/// One curve, or points without a line.
struct PlotSeries {
  std::string label;
  std::vector<std::pair<double, double>> points;
  bool marks = false; ///< points alone
};

/// A line across the plot at a value, as a gate or an angle.
struct PlotLimit {
  std::string label;
  double value = 0.0;
  bool upright = false; ///< at x = value
};

/// A small plot: axes, round ticks, curves in colours that the colour-blind tell apart and dashes that print
/// tells apart. Values that are not finite break a curve.
struct Plot {
  std::string title, x_label, y_label;
  std::vector<PlotSeries> series;
  std::vector<PlotLimit> limits;
  bool bars = false;         ///< the first series as a histogram, each point the left end of its bar
  bool equal_scales = false; ///< for plans

  [[nodiscard]] bool empty() const;
};

/// The plot as an inline SVG in a figure with its legend; colours are left to the page's style sheet
/// (classes series-0, series-1, …). Many points become fewer than a pixel apart at most.
std::string plot_html(const Plot& plot);

/// Round numbers that divide a range, at most `count` of them.
std::vector<double> round_ticks(double low, double high, int count);

/// Text safe inside HTML and attributes.
std::string html(const std::string& text);

} // namespace towform

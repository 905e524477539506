#include "report/plot.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace towform {

namespace {

constexpr double width = 480.0, height = 280.0, left = 58.0, right = 14.0, top = 12.0, bottom = 40.0;
constexpr int colours = 8; // classes that the style sheet has

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void add(double v)
  {
    if (!std::isfinite(v)) return;
    low = std::min(low, v);
    high = std::max(high, v);
  }
  [[nodiscard]] bool empty() const { return !(low <= high); }
};

/// A scale from a round range of values to places on the page.
struct Scale {
  double low, high, from, to;
  [[nodiscard]] double at(double v) const { return from + (v - low) / (high - low) * (to - from); }
};

Scale scale_of(Extent extent, double from, double to, bool to_round)
{
  if (extent.empty()) extent = {0.0, 1.0};
  if (extent.high - extent.low <= 1e-12 * std::max(std::abs(extent.high), std::abs(extent.low))) {
    const double room = extent.high == 0.0 ? 1.0 : 0.1 * std::abs(extent.high);
    extent = {extent.low - room, extent.high + room};
  }
  if (to_round) {
    const std::vector<double> ticks = round_ticks(extent.low, extent.high, 6);
    const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : extent.high - extent.low;
    extent = {std::floor(extent.low / step + 1e-9) * step, std::ceil(extent.high / step - 1e-9) * step};
  }
  return {extent.low, extent.high, from, to};
}

class Drawing {
public:
  explicit Drawing(const Plot& plot) : plot_(plot)
  {
    Extent x, y;
    for (const PlotSeries& s : plot.series)
      for (const auto& [px, py] : s.points) {
        x.add(px);
        y.add(py);
      }
    if (plot.bars) y.add(0.0);
    for (const PlotLimit& limit : plot.limits) (limit.upright ? x : y).add(limit.value);
    x_ = scale_of(x, left, width - right, plot.bars);
    y_ = scale_of(y, height - bottom, top, true);
    if (plot.equal_scales) make_equal();
  }

  std::string svg()
  {
    text_ = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">", width, height,
                        html(plot_.title));
    axes();
    limits();
    if (plot_.bars) bars();
    for (std::size_t i = plot_.bars ? 1 : 0; i < plot_.series.size(); ++i) curve(plot_.series[i], i);
    return text_ + "</svg>";
  }

private:
  void make_equal()
  {
    const double a = (x_.high - x_.low) / (x_.to - x_.from), b = (y_.high - y_.low) / (y_.from - y_.to);
    Scale& loose = a < b ? x_ : y_;
    const double wanted = std::max(a, b) * std::abs(loose.to - loose.from);
    const double more = 0.5 * (wanted - (loose.high - loose.low));
    loose.low -= more;
    loose.high += more;
  }

  void axes()
  {
    for (const double v : round_ticks(y_.low, y_.high, 6))
      text_ +=
          fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}H{:.1f}\"/><text x=\"{:.1f}\" y=\"{:.1f}\" "
                      "class=\"tick end\">{:.4g}</text>",
                      left, y_.at(v), width - right, left - 6.0, y_.at(v) + 4.0, v);
    for (const double v : round_ticks(x_.low, x_.high, 7))
      text_ +=
          fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}V{:.1f}\"/><text x=\"{:.1f}\" y=\"{:.1f}\" "
                      "class=\"tick middle\">{:.4g}</text>",
                      x_.at(v), top, height - bottom, x_.at(v), height - bottom + 16.0, v);
    text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"axis middle\">{}</text>",
                         0.5 * (left + width - right), height - 6.0, html(plot_.x_label));
    text_ +=
        fmt::format("<text transform=\"translate(13 {:.1f}) rotate(-90)\" class=\"axis middle\">{}</text>",
                    0.5 * (top + height - bottom), html(plot_.y_label));
  }

  void limits()
  {
    for (const PlotLimit& limit : plot_.limits) {
      const double at = (limit.upright ? x_ : y_).at(limit.value);
      if (limit.upright)
        text_ += fmt::format(
            "<path class=\"limit\" d=\"M{0:.1f} {1:.1f}V{2:.1f}\"/><text x=\"{3:.1f}\" y=\"{4:.1f}\" "
            "class=\"tick end\">{5}</text>",
            at, top, height - bottom, at - 4.0, top + 10.0, html(limit.label));
      else
        text_ += fmt::format(
            "<path class=\"limit\" d=\"M{0:.1f} {1:.1f}H{2:.1f}\"/><text x=\"{2:.1f}\" y=\"{3:.1f}\" "
            "class=\"tick end\">{4}</text>",
            left, at, width - right, at + 12.0, html(limit.label));
    }
  }

  void bars()
  {
    const auto& points = plot_.series.front().points;
    const double zero = y_.at(0.0);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const double from = x_.at(points[i].first), to = x_.at(points[i + 1].first),
                   up = y_.at(points[i].second);
      if (points[i].second > 0.0)
        text_ +=
            fmt::format("<rect class=\"bar\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>",
                        from, up, std::max(to - from - 0.6, 0.4), zero - up);
    }
  }

  void curve(const PlotSeries& series, std::size_t number)
  {
    std::string path;
    bool broken = true;
    std::pair<double, double> last{-1e9, -1e9};
    for (std::size_t i = 0; i < series.points.size(); ++i) {
      const auto& [vx, vy] = series.points[i];
      if (!std::isfinite(vx) || !std::isfinite(vy)) {
        broken = true;
        continue;
      }
      const std::pair<double, double> here{x_.at(vx), y_.at(vy)};
      if (series.marks) {
        text_ += fmt::format("<circle class=\"mark series-{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.2\"/>",
                             number % colours, here.first, here.second);
        continue;
      }
      const bool near = std::hypot(here.first - last.first, here.second - last.second) < 0.7;
      if (near && !broken && i + 1 < series.points.size()) continue;
      path += fmt::format("{}{:.1f} {:.1f}", broken ? 'M' : 'L', here.first, here.second);
      broken = false;
      last = here;
    }
    if (!path.empty())
      text_ += fmt::format("<path class=\"curve series-{}\" d=\"{}\"/>", number % colours, path);
  }

  const Plot& plot_;
  Scale x_{}, y_{};
  std::string text_;
};

} // namespace

bool Plot::empty() const
{
  return std::all_of(series.begin(), series.end(), [](const PlotSeries& s) { return s.points.empty(); });
}

std::vector<double> round_ticks(double low, double high, int count)
{
  if (!(high > low)) return {low};
  const double rough = (high - low) / std::max(count - 1, 1);
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10.0 * power;
  for (const double factor : {1.0, 2.0, 2.5, 5.0})
    if (factor * power >= rough * (1.0 - 1e-9)) {
      step = factor * power;
      break;
    }
  std::vector<double> ticks;
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k += 1.0)
    ticks.push_back(k == 0.0 ? 0.0 : k * step);
  return ticks;
}

std::string plot_html(const Plot& plot)
{
  std::string legend;
  if (plot.series.size() > 1)
    for (std::size_t i = 0; i < plot.series.size(); ++i)
      legend += fmt::format(
          "<li><svg class=\"key\" viewBox=\"0 0 24 8\">{}</svg>{}</li>",
          plot.series[i].marks
              ? fmt::format("<circle class=\"mark series-{}\" cx=\"12\" cy=\"4\" r=\"3.2\"/>", i % colours)
              : fmt::format("<path class=\"curve series-{}\" d=\"M1 4H23\"/>", i % colours),
          html(plot.series[i].label));
  return fmt::format("<figure><figcaption>{}</figcaption>{}{}</figure>\n", html(plot.title),
                     Drawing(plot).svg(), legend.empty() ? "" : "<ul class=\"legend\">" + legend + "</ul>");
}

std::string html(const std::string& text)
{
  std::string safe;
  for (const char c : text) switch (c) {
    case '&':
      safe += "&amp;";
      break;
    case '<':
      safe += "&lt;";
      break;
    case '>':
      safe += "&gt;";
      break;
    case '"':
      safe += "&quot;";
      break;
    default:
      safe += c;
    }
  return safe;
}

} // namespace towform

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/cli/simulate.hpp"
#include "torsor/generator/printing/html_text.hpp"

namespace torsor {
namespace {

constexpr double plot_left = 80, plot_right = 780, plot_top = 40, plot_bottom = 430;

/// 1, 2 or 5 times a power of ten, near the given length.
double nice_step(double wanted) {
  const double power = std::pow(10.0, std::floor(std::log10(wanted))), rest = wanted / power;
  return power * (rest < 1.5 ? 1 : rest < 3.5 ? 2 : rest < 7.5 ? 5 : 10);
}

std::string grid_line(double x1, double y1, double x2, double y2) {
  return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"#d0d0d0\"/>\n", x1, y1, x2, y2);
}

}  // namespace

std::string simulation_svg(const Scene& scene, const Simulation& motion, const std::vector<std::string>& columns) {
  std::vector<std::size_t> places;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const std::string& name : columns) {
    const auto found = std::find(motion.names.begin(), motion.names.end(), name);
    if (found == motion.names.end()) {
      throw UsageError(fmt::format("there is no column '{}' to plot: {}there are {}", name,
                                   did_you_mean(name, motion.names), fmt::join(motion.names, ", ")));
    }
    places.push_back(static_cast<std::size_t>(found - motion.names.begin()));
    for (const std::vector<double>& row : motion.rows) {
      low = std::min(low, row[places.back()]);
      high = std::max(high, row[places.back()]);
    }
  }
  if (places.empty()) throw UsageError("--plot takes a file and the names of columns, e.g. --plot motion.svg theta");
  const double least = 1e-12 * std::max({1e-6, std::abs(low), std::abs(high)});
  if (high - low < least) {
    low -= std::max(1.0, std::abs(low)) / 2;
    high += std::max(1.0, std::abs(high)) / 2;
  }
  const double end = std::max(motion.rows.back()[0], std::numeric_limits<double>::min());
  const auto x = [&](double t) { return plot_left + (plot_right - plot_left) * t / end; };
  const auto y = [&](double v) { return plot_bottom - (plot_bottom - plot_top) * (v - low) / (high - low); };
  const std::string title = scene.content().title.empty() ? scene.name() : scene.content().title;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"800\" height=\"500\" viewBox=\"0 0 800 500\" "
      "font-family=\"sans-serif\" font-size=\"12\">\n<title>{0}</title>\n<rect width=\"800\" height=\"500\" "
      "fill=\"#ffffff\"/>\n<text x=\"400\" y=\"22\" text-anchor=\"middle\" font-size=\"15\">{0}</text>\n",
      html_escaped(title));
  const double step_y = nice_step((high - low) / 5), step_x = nice_step(end / 8);
  for (double v = std::ceil(low / step_y) * step_y; v <= high + 1e-9 * step_y; v += step_y) {
    svg += grid_line(plot_left, y(v), plot_right, y(v));
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{:.6g}</text>\n", plot_left - 6, y(v) + 4,
                       std::abs(v) < 1e-9 * step_y ? 0.0 : v);
  }
  for (double t = 0; t <= end * (1 + 1e-9); t += step_x) {
    svg += grid_line(x(t), plot_top, x(t), plot_bottom);
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{:.6g}</text>\n", x(t), plot_bottom + 16, t);
  }
  svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">time [s]</text>\n", (plot_left + plot_right) / 2, plot_bottom + 34);
  static constexpr std::array<const char*, 8> colours{"#2266bb", "#cc4b33", "#33935a", "#985bb3",
                                                      "#c98f10", "#1a94a6", "#c65a8c", "#72802f"};
  const std::size_t stride = std::max<std::size_t>(1, motion.rows.size() / 2000);
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::string path;
    for (std::size_t k = 0; k < motion.rows.size(); k += stride) {
      path += fmt::format("{}{:.1f} {:.1f}", k == 0 ? "M" : "L", x(motion.rows[k][0]), y(motion.rows[k][places[i]]));
    }
    svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"/>\n", path, colours[i % 8]);
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" fill=\"{}\">{} [{}]</text>\n", plot_left + 175.0 * static_cast<double>(i % 4),
                       plot_bottom + 52 + 15.0 * static_cast<double>(i / 4), colours[i % 8], html_escaped(columns[i]),
                       html_escaped(motion.units[places[i]]));
  }
  return svg + "</svg>\n";
}

}  // namespace torsor
